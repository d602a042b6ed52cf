#include "ros/waypoint_follower/waypoint_follower_adapter.h"

#include <geometry_msgs/PoseArray.h>

#include "frontier_pilot/navigation/navigator_types.h"
#include "ros/common/messages/conversions.h"
#include "ros/common/parameters.h"
#include "ros/common/throttled_log.h"
#include "ros/waypoint_follower/waypoint_messages.h"
#include "ros/waypoint_follower/waypoint_problem.h"

namespace frontier_pilot {

WaypointFollowerAdapter::WaypointFollowerAdapter(ros::NodeHandle& node, ros::NodeHandle& private_node)
    : parameters_(loadNodeParameters<waypoints::WaypointParameters>(private_node)),
      follower_(parameters_),
      own_goals_(
          node.advertise<FollowWaypointsActionGoal>(std::string(names::kFollowWaypoints) + names::kGoalOfAction, 1)),
      collected_publisher_(node.advertise<geometry_msgs::PoseArray>(names::kWaypoints, 1, true)),
      navigation_(node, names::kMoveBase),
      server_(
          node, names::kFollowWaypoints, [this](const FollowWaypointsGoal& goal) { handleGoal(goal); },
          [this](const std::string&) { put(follower_.cancel()); }),
      diagnostics_(node, private_node),
      connections_(node) {
  constexpr double kPeriod = 0.1;  // [s]
  diagnostics_.add("waypoints", [this](auto& status) { diagnose(status); });
  diagnostics_.add("connections", [this](auto& status) { connections_.report(status); });
  connections_.followStop(&WaypointFollowerAdapter::handleStop, this);
  connections_.subscribe(names::kArbiterStatus, 1, &WaypointFollowerAdapter::handleArbiter, this);
  connections_.subscribeToCommands(names::kAddWaypoint, 20, &WaypointFollowerAdapter::handleAdd, this);
  connections_.subscribe(names::kMapReplaced, 1, &WaypointFollowerAdapter::handleReplaced, this);
  connections_.serve(names::kStartWaypoints, &WaypointFollowerAdapter::handleStart, this);
  connections_.serve(names::kClearWaypoints, &WaypointFollowerAdapter::handleClear, this);
  connections_.every(ros::Duration(kPeriod), [this] { tick(); });
  connections_.clock().onJump([this] { put(follower_.abortByClockJump()); });
}

void WaypointFollowerAdapter::sayLastWords() {
  if (follower_.active()) put(follower_.cancel());
}

void WaypointFollowerAdapter::handleGoal(const FollowWaypointsGoal& goal) {
  // The action server has already ended the waypoints that were under way.
  inputs_.ended.clear();
  follows_collected_ = false;
  if (const auto output = follower_.start(goal.poses.size(), rosNow()); output.ended) return put(output);
  if (const std::string why = problemOfWaypoints(goal.poses); !why.empty()) return put(follower_.refuse(why));
  poses_ = goal.poses;
  THROTTLED_INFO("follows " << poses_.size() << " waypoints");
  tick();
}

void WaypointFollowerAdapter::handleStop(const std_msgs::Bool& msg) {
  inputs_.emergency_stop = msg.data != 0;
  if (inputs_.emergency_stop) step(connections_.clock().now().value_or(rosNow()));  // also by a clock that just jumped
}

void WaypointFollowerAdapter::handleArbiter(const ArbiterStatus& msg) { permission_.take(msg, rosNow(), steadyNow()); }

void WaypointFollowerAdapter::handleLegEnd(std::uint32_t leg, const actionlib::TerminalState& state) {
  const std::string text = state.getText().empty() ? state.toString() : state.getText();
  inputs_.ended.push_back({leg, kindOf(state), text});
  tick();  // at once, so that an explorer finds no gap between two goals
  // Nobody else says so of the map of another node, as of a map_server in place of the mapper.
  if (text == navigation::toString(navigation::NavReason::kMapReplaced)) dropCollected(text);
}

void WaypointFollowerAdapter::tick() {
  if (const auto now = connections_.clock().now(); !connections_.clock().isCatchingUp()) step(now);
}

void WaypointFollowerAdapter::step(const std::optional<Time>& now) {
  if (!now) return;
  inputs_.navigation_up = navigation_.isServerConnected();
  inputs_.navigation_serves_others = navigation_.servesOthers();
  inputs_.navigation_refused = permission_.refusal(*now, steadyNow());
  const waypoints::WaypointOutput output = follower_.update(inputs_, *now);
  inputs_.ended.clear();
  put(output);
}

void WaypointFollowerAdapter::put(const waypoints::WaypointOutput& output) {
  if (output.cancel) {
    navigation_.cancel();
    navigation_.forget();
  }
  if (output.send) send(*output.send);
  if (output.ended) finish(output);
}

void WaypointFollowerAdapter::send(const waypoints::Leg& leg) {
  move_base_msgs::MoveBaseGoal goal;
  goal.target_pose = poses_.at(leg.waypoint);
  goal.target_pose.header.stamp = toRosTime(rosNow());
  FollowWaypointsFeedback feedback;
  feedback.current_waypoint = static_cast<std::uint32_t>(leg.waypoint);
  server_.publishFeedback(feedback);
  navigation_.send(goal, [this, id = leg.leg](const auto& state, const auto&) { handleLegEnd(id, state); });
}

void WaypointFollowerAdapter::finish(const waypoints::WaypointOutput& output) {
  last_text_ = output.text;
  poses_.clear();
  FollowWaypointsResult result;
  result.error_code = codeOf(output.outcome);
  if (result.error_code != FollowWaypointsResult::NONE) result.error_msg = output.text;
  for (const std::size_t waypoint : follower_.missed())
    result.missed_waypoints.push_back(static_cast<std::uint32_t>(waypoint));
  if (output.outcome == waypoints::WaypointOutcome::kCompleted) {
    server_.setSucceeded(result, output.text);
  } else if (output.outcome == waypoints::WaypointOutcome::kCanceled) {
    server_.setPreempted(result, output.text);
  } else {
    server_.setAborted(result, output.text);
  }
  THROTTLED_INFO("waypoints: " << output.text);
  diagnostics_.publish();
}

}  // namespace frontier_pilot
