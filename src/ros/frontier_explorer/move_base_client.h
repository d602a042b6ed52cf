#pragma once

#include <move_base_msgs/MoveBaseAction.h>
#include <ros/node_handle.h>

#include <string>
#include <vector>

#include "frontier_pilot/exploration/explorer_types.h"
#include "ros/common/actions/action_client.h"

namespace frontier_pilot {

/// The explorer's client of the `move_base` action, whichever node serves it. Nothing here blocks: what happens to a
/// goal is collected as events.
class MoveBaseClient {
 public:
  explicit MoveBaseClient(ros::NodeHandle& node);

  /// Whether a server is connected now.
  bool available() { return client_.isServerConnected(); }
  /// Whether the server pursues a goal of another client. [EXP-11]
  bool servesOthers() const { return client_.servesOthers(); }
  /// Sends a goal, which replaces the present one if there is one; the end of the old one is not reported.
  void send(std::uint32_t goal_id, const Pose2& goal, const std::string& frame, Time now);
  /// Cancels the goal that was sent last; goals of other clients are not affected.
  void cancel();
  /// The events since the last call.
  std::vector<exploration::GoalEvent> takeEvents();
  void report(diagnostic_updater::DiagnosticStatusWrapper& status) const { client_.report(status); }

 private:
  void handleDone(std::uint32_t goal_id, const actionlib::TerminalState& state);

  ActionClient<move_base_msgs::MoveBaseAction> client_;
  bool active_ = false;
  std::vector<exploration::GoalEvent> events_;
};

}  // namespace frontier_pilot
