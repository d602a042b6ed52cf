#include <geometry_msgs/PoseArray.h>

#include "ros/common/clock.h"
#include "ros/common/names.h"
#include "ros/common/tf/frame_name.h"
#include "ros/common/throttled_log.h"
#include "ros/waypoint_follower/waypoint_follower_adapter.h"
#include "ros/waypoint_follower/waypoint_problem.h"

/// Waypoints that are collected one by one, and what the node says of itself.
namespace frontier_pilot {

void WaypointFollowerAdapter::handleAdd(const geometry_msgs::PoseStamped& msg) {
  std::string why = problemOfWaypoint(msg);
  const bool other_frame = !collected_.empty() && !isSameFrame(msg.header.frame_id, collected_.front().header.frame_id);
  if (why.empty() && other_frame)
    why = "in frame '" + msg.header.frame_id + "', the others are in '" + collected_.front().header.frame_id + "'";
  if (why.empty() && collected_.size() >= static_cast<std::size_t>(parameters_.max_waypoints))
    why = "more than max_waypoints";
  if (!why.empty()) return bad_poses_.add(why);
  collected_.push_back(msg);
  publishCollected();
}

/// Sends the collected waypoints as a goal of the node's own action, where they are seen and cancelled like others.
bool WaypointFollowerAdapter::handleStart(Trigger::Request&, Trigger::Response& response) {
  response.success = 0;
  response.message = "no waypoints were added";
  if (collected_.empty()) return true;
  response.message = "the robot is stopped: clear the emergency stop first";
  if (inputs_.emergency_stop) return true;
  response.success = 1;
  response.message = "follows " + std::to_string(collected_.size()) + " waypoints";
  FollowWaypointsGoal goal;
  goal.poses = collected_;
  own_goals_.publish(server_.offer(goal));
  follows_collected_ = follower_.active();
  return true;
}

/// Ends also the drive to them, but not that of an action of somebody else.
bool WaypointFollowerAdapter::handleClear(Trigger::Request&, Trigger::Response& response) {
  const bool drives = follows_collected_ && follower_.active();
  if (drives) put(follower_.cancel());
  response.success = 1;
  response.message =
      std::to_string(collected_.size()) + " waypoints taken back" + (drives ? ", and the drive to them is ended" : "");
  collected_.clear();
  publishCollected();
  return true;
}

/// They were places on the map of before, whoever has given them. [MAP-5]
void WaypointFollowerAdapter::handleReplaced(const std_msgs::String& msg) {
  put(follower_.abortByMap());
  dropCollected(msg.data);
}

void WaypointFollowerAdapter::dropCollected(const std::string& why) {
  if (collected_.empty()) return;
  THROTTLED_WARN(collected_.size() << " collected waypoints are dropped: " << why);
  collected_.clear();
  publishCollected();
}

void WaypointFollowerAdapter::publishCollected() {
  geometry_msgs::PoseArray msg;
  msg.header.stamp = toRosTime(rosNow());
  if (!collected_.empty()) msg.header.frame_id = collected_.front().header.frame_id;
  for (const geometry_msgs::PoseStamped& pose : collected_) msg.poses.push_back(pose.pose);
  collected_publisher_.publish(msg);
}

void WaypointFollowerAdapter::diagnose(diagnostic_updater::DiagnosticStatusWrapper& status) const {
  using Level = diagnostic_msgs::DiagnosticStatus;
  if (follower_.active() && !inputs_.navigation_up) {
    status.summary(Level::WARN, "waits: nothing serves move_base");
  } else if (follower_.active()) {
    status.summary(Level::OK,
                   "waypoint " + std::to_string(follower_.current() + 1) + " of " + std::to_string(follower_.count()));
  } else {
    status.summary(Level::OK, "ready");
  }
  status.add("last waypoints", last_text_);
  status.add("waypoints collected", collected_.size());
  bad_poses_.report(status);
  navigation_.report(status);
  server_.report(status);
}

}  // namespace frontier_pilot
