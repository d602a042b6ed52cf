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

/// Publishes the navigator's plans, its costmaps (only while subscribed to, and at a low rate), its status and
/// its progress.
class NavigatorPublisher {
 public:
  /// `max_linear` [m/s] of the robot, for the time that is left.
  NavigatorPublisher(ros::NodeHandle& node, std::string map_frame, double max_linear);

  void setMaxLinear(double max_linear) { max_linear_ = max_linear; }
  /// `goal`: the one that is being pursued, in the map's frame.
  void publish(const navigation::Navigator& navigator, const navigation::NavigatorOutput& output,
               const std::optional<Pose2>& goal, const std::optional<Pose2>& T_map_base, Time now);
  const std::string& status() const { return status_; }

 private:
  /// Returns whether the status has changed.
  bool publishStatus(const navigation::NavigatorOutput& output);
  void publishProgress(const navigation::Navigator& navigator, const std::optional<Pose2>& goal, Time now);
  void publishCostmaps(const planning::ClearanceMap& map, const std::optional<Pose2>& T_map_base, Time now);

  std::string map_frame_;
  double max_linear_;
  std::string status_;
  std::optional<Pose2> told_goal_;
  std::optional<Time> progress_published_;
  std::optional<Time> local_published_;
  std::optional<Time> global_published_;
  ros::Publisher plan_;
  ros::Publisher local_plan_;
  ros::Publisher local_costmap_;
  ros::Publisher global_costmap_;
  ros::Publisher status_publisher_;
  ros::Publisher progress_;
};

/// The points as poses, with the direction to the next point as yaw; the last one has the yaw of its predecessor.
std::vector<Pose2> withYaw(const std::vector<Vec2>& points);

/// The costs of the cells of `rect` in the scale of rviz' costmap colours: -1 unknown, 0 to 98 free with rising cost,
/// 99 too near to an obstacle for the robot's centre, 100 obstacle.
OccupancyGrid costmap(const planning::ClearanceMap& map, const CellRect& rect);

}  // namespace frontier_pilot
