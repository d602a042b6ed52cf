#pragma once

#include <actionlib_msgs/GoalStatusArray.h>
#include <frontier_pilot/PatrolAction.h>
#include <ros/node_handle.h>

#include <optional>
#include <string>

#include "frontier_pilot/core/time.h"
#include "frontier_pilot/patrol/command_line.h"
#include "ros/common/actions/action_client.h"

namespace frontier_pilot {

/// `patrol_client` on the command line: one goal from sending to its result, with the server watched all the while.
class PatrolClientAdapter {
 public:
  PatrolClientAdapter(ros::NodeHandle& node, const patrol::PatrolOrder& order);

  /// One look: sends the goal once the server is there, cancels it once `interrupts` is above 0. Gives how it ended, as
  /// soon as it has. To be called often, between callbacks.
  std::optional<patrol::PatrolExit> update(int interrupts);

 private:
  enum class Phase { kConnecting, kRunning, kCanceling };

  std::optional<patrol::PatrolExit> connect(int interrupts);
  std::optional<patrol::PatrolExit> watch(int interrupts);
  bool serverLost();
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
  SteadyTime heard_;  ///< when the server last said something
  Time heard_ros_;    ///< the same in ROS time, which a server's heart beats in
  std::optional<patrol::PatrolExit> outcome_;
};

/// The whole program.
int runPatrolClient(int argc, char** argv);

}  // namespace frontier_pilot
