#pragma once

#include <geometry_msgs/PoseStamped.h>
#include <move_base_msgs/MoveBaseAction.h>
#include <ros/node_handle.h>
#include <std_msgs/String.h>

#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "frontier_pilot/navigation/navigator_types.h"
#include "ros/common/actions/action_server.h"
#include "ros/common/diagnostics.h"
#include "ros/common/node_connections.h"
#include "ros/common/tf/tf_bridge.h"

namespace frontier_pilot {

/// Turns the `move_base` action and `move_base_simple/goal` into inputs of the navigator. One goal is pursued at a
/// time, and a newer one preempts it; there is no execute loop. Goals are transformed into the map's frame on arrival.
class MoveBaseServer {
 public:
  MoveBaseServer(ros::NodeHandle& node, const TfBridge& tf, std::string map_frame, bool use_yaw);

  /// Subscribes to `move_base_simple/goal`, which rviz publishes. As in move_base, its goals become goals of the
  /// action. And to `mapper/replaced`: no goal outlives the map that it was meant for. [NAV-1]
  void subscribe(NodeConnections& connections);
  /// Whether the emergency stop is latched. No goal outlives it, and none that comes meanwhile: nobody expects that the
  /// robot drives after the clear. [ARB-8]
  void setStopped(bool stopped);
  bool isStopped() const { return stopped_since_.has_value(); }
  /// Ends all goals, which were meant for a map that has been replaced. [NAV-1]
  void endForReplacedMap();
  /// Moves what has come since the last call into `inputs`: a new goal, a cancel, and that the map was replaced.
  void fill(navigation::NavigatorInputs& inputs);
  /// Sends the result of a goal to its client.
  void settle(const navigation::NavFinished& finished);
  /// Ends all goals that the navigator was given, with `why`, and has it cancel what it still pursues.
  void abortAll(const std::string& why);
  void feedback(const Pose2& T_map_base, Time stamp);
  /// The goal that the navigator was given last, until it has ended; in the map's frame.
  const std::optional<Pose2>& goal() const { return goal_; }
  /// For /diagnostics: which goals were refused, those of `move_base_simple/goal` included, which get no answer.
  void report(diagnostic_updater::DiagnosticStatusWrapper& status) const {
    server_.report(status);
    bad_simple_goals_.report(status);
  }

 private:
  using Server = ActionServer<move_base_msgs::MoveBaseAction>;

  void handleGoal(const Server::GoalHandle& offered);
  void handleCancel(const Server::GoalHandle& handle);
  /// Cancels every goal, as a client would.
  void cancelAll();
  void cancelForStop();
  void handleReplaced(const std_msgs::String&) { endForReplacedMap(); }
  void handleSimple(const geometry_msgs::PoseStamped& msg);
  /// The goal in the map's frame; nothing if it is malformed or its frame is not in TF, with the reason in `why`.
  std::optional<Pose2> read(const geometry_msgs::PoseStamped& msg, std::string& why) const;
  std::uint64_t submit(const Pose2& T_map_goal);

  const TfBridge& tf_;
  std::string map_frame_;
  bool use_yaw_;
  std::uint64_t last_id_ = 0;
  std::uint64_t active_id_ = 0;  ///< 0: none
  std::optional<navigation::NavGoal> pending_;
  std::optional<Pose2> goal_;
  ros::Publisher simple_goals_;  ///< of the action itself: they are seen and cancelled like all others
  ros::Publisher current_goal_;
  bool cancel_ = false, map_replaced_ = false;
  std::optional<SteadyTime> stopped_since_;
  Rejections bad_simple_goals_{"goal of move_base_simple"};
  std::map<std::uint64_t, Server::GoalHandle> handles_;  ///< by id
  Server server_;
};

}  // namespace frontier_pilot
