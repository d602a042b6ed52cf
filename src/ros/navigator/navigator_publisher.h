#pragma once

#include <nav_msgs/OccupancyGrid.h>
#include <ros/node_handle.h>

#include <optional>
#include <string>
#include <vector>

#include "frontier_pilot/core/geometry.h"
#include "frontier_pilot/core/time.h"
#include "frontier_pilot/navigation/navigator.h"
#include "frontier_pilot/planning/clearance_map.h"

namespace frontier_pilot {

/// What the navigator shows: plans, costmaps (only while somebody looks, and not often) and its status.
class NavigatorPublisher {
 public:
  NavigatorPublisher(ros::NodeHandle& node, std::string map_frame);

  void publish(const navigation::Navigator& navigator, const navigation::NavigatorOutput& output,
               const std::optional<Pose2>& T_map_base, Time now);
  const std::string& status() const { return status_; }

 private:
  void publishStatus(const navigation::NavigatorOutput& output);
  void publishCostmaps(const planning::ClearanceMap& map, const std::optional<Pose2>& T_map_base, Time now);

  std::string map_frame_;
  std::string status_;
  std::optional<Time> local_published_;
  std::optional<Time> global_published_;
  ros::Publisher plan_;
  ros::Publisher local_plan_;
  ros::Publisher local_costmap_;
  ros::Publisher global_costmap_;
  ros::Publisher status_publisher_;
};

/// The points with the direction to the next one as yaw; the last one keeps its predecessor's.
std::vector<Pose2> withYaw(const std::vector<Vec2>& points);

/// Costs in rviz's costmap scale for the cells of `rect`: -1 unknown, 0 free, ... 98, 99 too near for the robot's
/// centre, 100 obstacle.
OccupancyGrid costmap(const planning::ClearanceMap& map, const CellRect& rect);

}  // namespace frontier_pilot
