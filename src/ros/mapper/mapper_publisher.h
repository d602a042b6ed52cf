#pragma once

#include <ros/node_handle.h>

#include <optional>
#include <string>

#include "frontier_pilot/core/time.h"
#include "frontier_pilot/mapping/map_schedule.h"
#include "frontier_pilot/mapping/mapper.h"
#include "ros/common/maps/map_changes_publisher.h"

namespace frontier_pilot {

/// Publishes the map: changes at once on `map_updates`, the whole map less often, both in few bytes on `map_changes`,
/// and nothing while another node publishes `map`, nor before it is known that none does. [MAP-2] [MAP-3]
/// The message of the whole map, a byte for each cell of the box around it, is made when it is sent.
class MapperPublisher {
 public:
  /// The topics of the map are not advertised yet.
  MapperPublisher(const ros::NodeHandle& node, std::string frame, const mapping::MapScheduleParameters& schedule);

  /// The topic, resolved.
  std::string topic() const { return node_.resolveName(topic_); }
  /// `node` is another node that publishes the map, or empty if there is none: then this one advertises its topics,
  /// otherwise it withdraws them.
  void setOther(const std::string& node);
  const std::string& other() const { return other_; }
  /// Whether this mapper owns the map: otherwise it also must not say where the robot is.
  bool owns() const { return advertised_; }

  void publish(mapping::Mapper& mapper, Time now);
  /// Publishes on `mapper/replaced` that another map is there now, and why: what was meant for the map of before, such
  /// as a goal, is void. Not if another node publishes the map and this one never has: nothing was meant for its map.
  void announceReplacement(const std::string& why);
  /// Publishes on `mapper/localized` that the robot is not found on the map: when that is new, and once a second, so
  /// that what somebody else has said there does not stay. [MAP-5]
  void publishLost();
  /// To be called after each transform of a robot that is localised. Says so in the same way; after the robot was lost,
  /// only once the transforms hold, `lead` after the first one: until then others look up its former place.
  void publishLocalized(Duration lead);

 private:
  void sayLocalized(bool localized);
  void advertiseLocalized();
  void advertise();
  void withdraw();
  void publishChanges(const occupancy::OccupancyMap& map, const CellRect& cells, Time now);
  void publishWhole(const occupancy::OccupancyMap& map, Time now);

  ros::NodeHandle node_;
  std::string topic_;
  std::string frame_;
  mapping::MapSchedule schedule_;
  std::string other_;
  bool advertised_ = false;
  bool has_published_ = false;  ///< a map, ever
  ros::Publisher map_;
  ros::Publisher updates_;
  ros::Publisher metadata_;
  MapChangesPublisher compact_;
  ros::Publisher localized_, replaced_;
  std::optional<Time> found_at_;  ///< ROS time of the first transform since the robot is localised
  std::optional<bool> said_localized_;
  SteadyTime said_at_;
};

}  // namespace frontier_pilot
