#pragma once

#include <actionlib_msgs/GoalStatusArray.h>
#include <frontier_pilot/PatrolAction.h>
#include <ros/node_handle.h>

#include <optional>
#include <string>

#include "frontier_pilot/core/time.h"
#include "frontier_pilot/patrol/command_line.h"
#include "frontier_pilot/patrol/patrol.h"
#include "ros/common/actions/action_client.h"

namespace frontier_pilot {

/// The command-line program `patrol_client`: sends one goal and waits for its result, watching the server meanwhile.
class PatrolClientAdapter {
 public:
  PatrolClientAdapter(ros::NodeHandle& node, const patrol::PatrolOrder& order);

  /// One step: sends the goal once the server is connected, and cancels it once `interrupts` is above 0. Returns the
  /// outcome as soon as there is one. To be called often, between callbacks.
  std::optional<patrol::PatrolExit> update(int interrupts);

  /// Whether a cancel was sent that the server has not answered, and may answer yet.
  bool awaitsCancel() { return phase_ == Phase::kCanceling && !outcome_ && client_.isServerConnected(); }

  /// Prints a line on stderr that begins with the program's name.
  static void complain(const std::string& text);

 private:
  enum class Phase { kConnecting, kRunning, kCanceling };

  std::optional<patrol::PatrolExit> connect(int interrupts);
  std::optional<patrol::PatrolExit> watch(int interrupts);
  bool serverLost();
  void cancel();
  void send();
  void handleStatus();
  void handleFeedback(const PatrolFeedbackConstPtr& feedback);
  void handleDone(const actionlib::TerminalState& state, const PatrolResultConstPtr& result);

  patrol::PatrolOrder order_;
  ActionClient<PatrolAction> client_;
  UnreadableMessages unreadable_;
  ros::Subscriber status_;
  Phase phase_ = Phase::kConnecting;
  SteadyTime since_;  ///< when the phase began
  SteadyTime heard_;  ///< when the last status of the server arrived
  Time heard_ros_;    ///< the same in ROS time
  std::optional<patrol::PatrolExit> outcome_;
};

/// Runs the program and returns its exit code.
int runPatrolClient(int argc, char** argv);

}  // namespace frontier_pilot
