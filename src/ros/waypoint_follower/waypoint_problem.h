#pragma once

#include <geometry_msgs/PoseStamped.h>

#include <string>
#include <vector>

namespace frontier_pilot {

/// Why this is no pose to go to; empty if it is one. [FLT-1]
std::string problemOfWaypoint(const geometry_msgs::PoseStamped& msg);
/// Which of the waypoints is no pose to go to, and why; empty if each is one.
std::string problemOfWaypoints(const std::vector<geometry_msgs::PoseStamped>& poses);

}  // namespace frontier_pilot
