#pragma once

#include <frontier_pilot/ArbiterStatus.h>
#include <frontier_pilot/FollowWaypointsAction.h>
#include <geometry_msgs/PoseStamped.h>
#include <move_base_msgs/MoveBaseAction.h>
#include <ros/node_handle.h>
#include <std_msgs/Bool.h>
#include <std_msgs/String.h>
#include <std_srvs/Trigger.h>

#include <string>
#include <vector>

#include "ros/common/actions/action_client.h"
#include "ros/common/actions/action_server.h"
#include "ros/common/diagnostics.h"
#include "ros/common/inputs/navigation_permission.h"
#include "ros/common/node_connections.h"
#include "waypoints/waypoint_follower.h"

namespace frontier_pilot {

/// The node `waypoint_follower`: a WaypointFollower as the action `follow_waypoints`, and a client of `move_base`,
/// whichever node serves it. Waypoints may also be collected one by one, as rviz publishes them. [NAV-5]
class WaypointFollowerAdapter {
 public:
  WaypointFollowerAdapter(ros::NodeHandle& node, ros::NodeHandle& private_node);
  /// Cancels the goal that is under way.
  void sayLastWords();

 private:
  using Server = SingleGoalServer<FollowWaypointsAction>;
  using Trigger = std_srvs::Trigger;

  void handleGoal(const FollowWaypointsGoal& goal);
  void handleStop(const std_msgs::Bool& msg);
  void handleArbiter(const ArbiterStatus& msg);
  void handleLegEnd(std::uint32_t leg, const actionlib::TerminalState& state);
  void tick();
  void step(const std::optional<Time>& now);
  void put(const waypoints::WaypointOutput& output);
  void send(const waypoints::Leg& leg);
  void finish(const waypoints::WaypointOutput& output);
  // Waypoints that are collected one by one; see waypoint_collection.cpp.
  void handleAdd(const geometry_msgs::PoseStamped& msg);
  bool handleStart(Trigger::Request& request, Trigger::Response& response);
  bool handleClear(Trigger::Request& request, Trigger::Response& response);
  void handleReplaced(const std_msgs::String& msg);
  void dropCollected(const std::string& why);
  void publishCollected();
  void diagnose(diagnostic_updater::DiagnosticStatusWrapper& status) const;

  waypoints::WaypointParameters parameters_;
  waypoints::WaypointFollower follower_;
  waypoints::WaypointInputs inputs_;
  NavigationPermission permission_;
  std::vector<geometry_msgs::PoseStamped> poses_;      ///< of the present goal
  std::vector<geometry_msgs::PoseStamped> collected_;  ///< all in one frame
  bool follows_collected_ = false;                     ///< the present goal is of those
  std::string last_text_ = "no waypoints yet";
  Rejections bad_poses_{"waypoint"};
  ros::Publisher own_goals_, collected_publisher_;
  ActionClient<move_base_msgs::MoveBaseAction> navigation_;
  Server server_;
  NodeDiagnostics diagnostics_;
  NodeConnections connections_;
};

}  // namespace frontier_pilot
