#pragma once

#include <nav_msgs/OccupancyGrid.h>
#include <ros/node_handle.h>

#include <string>

#include "frontier_pilot/core/time.h"
#include "frontier_pilot/mapping/map_schedule.h"
#include "frontier_pilot/mapping/mapper.h"

namespace frontier_pilot {

/// Publishes the map: changes at once on `map_updates`, the whole map less often, and nothing while another node
/// publishes `map`. [MAP-2] [MAP-3]
/// The whole map is kept as a message, in which changed cells are replaced.
class MapperPublisher {
 public:
  /// Nothing is advertised yet.
  MapperPublisher(const ros::NodeHandle& node, std::string frame, const mapping::MapScheduleParameters& schedule);

  /// The topic, resolved.
  std::string topic() const { return node_.resolveName(topic_); }
  /// `node` is another node that publishes the map, or empty if there is none: then this one advertises its topics,
  /// otherwise it withdraws them.
  void setOther(const std::string& node);
  const std::string& other() const { return other_; }

  void publish(mapping::Mapper& mapper, Time now);

 private:
  void advertise();
  void withdraw();
  void patch(const OccupancyGrid& grid, const occupancy::MapChanges& changes);
  void publishWhole(Time now);

  ros::NodeHandle node_;
  std::string topic_;
  std::string frame_;
  mapping::MapSchedule schedule_;
  std::string other_;
  bool advertised_ = false;
  ros::Publisher map_;
  ros::Publisher updates_;
  ros::Publisher metadata_;
  nav_msgs::OccupancyGrid whole_;  ///< the present map
};

}  // namespace frontier_pilot
