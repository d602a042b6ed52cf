#include "ros/waypoint_follower/waypoint_problem.h"

#include "ros/common/messages/conversions.h"
#include "ros/common/tf/frame_name.h"

namespace frontier_pilot {

std::string problemOfWaypoint(const geometry_msgs::PoseStamped& msg) {
  std::string why;
  if (!toPose(msg.pose, &why)) return why;
  return msg.header.frame_id.empty() ? "no frame" : problemOfFrameName(msg.header.frame_id);
}

std::string problemOfWaypoints(const std::vector<geometry_msgs::PoseStamped>& poses) {
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const std::string why = problemOfWaypoint(poses[i]);
    if (!why.empty()) return "waypoint " + std::to_string(i + 1) + ": " + why;
  }
  return "";
}

}  // namespace frontier_pilot
