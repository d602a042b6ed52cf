#pragma once

#include <nav_msgs/OccupancyGrid.h>
#include <ros/node_handle.h>

#include <string>

#include "frontier_pilot/core/time.h"
#include "frontier_pilot/mapping/map_schedule.h"
#include "frontier_pilot/mapping/mapper.h"

namespace frontier_pilot {

/// Publishes the map: what changed at once, the whole of it seldom, and nothing while another node owns the topic.
/// [MAP-2] [MAP-3]
/// The whole map is kept as a message and patched.
class MapperPublisher {
 public:
  /// Nothing is advertised yet.
  MapperPublisher(const ros::NodeHandle& node, std::string frame, const mapping::MapScheduleParameters& schedule);

  /// The topic, resolved.
  std::string topic() const { return node_.resolveName(topic_); }
  /// Another node that publishes the topic; empty if there is none. Advertises in the latter case, and withdraws in the
  /// former.
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
  nav_msgs::OccupancyGrid whole_;  ///< the map as it is
};

}  // namespace frontier_pilot
