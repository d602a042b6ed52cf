#pragma once

#include <actionlib/action_definition.h>
#include <actionlib/goal_id_generator.h>
#include <actionlib_msgs/GoalStatusArray.h>
#include <frontier_pilot/PatrolAction.h>
#include <frontier_pilot/SpinAction.h>
#include <ros/node_handle.h>

#include <mutex>
#include <string>

#include "ros/common/node_connections.h"
#include "ros/teleop_gui/service_caller.h"

namespace frontier_pilot {

/// An action as an operator has it: it shows and stops everybody's goals, not only those started here, which a
/// SimpleActionClient cannot. May be used from any thread. For PatrolAction and SpinAction.
template <class Action>
class ActionLink {
 public:
  ACTION_DEFINITION(Action)

  /// `name` is what the log calls it.
  ActionLink(ros::NodeHandle& node, NodeConnections& connections, const std::string& action, std::string name,
             OperatorLog log);

  void start(const Goal& goal);
  /// Every goal, whoever started it.
  void cancelAll();
  /// The one that was started here, if it may still be going on.
  void cancelOwn();
  teleop::ActionView view() const;

 private:
  void onStatus(const actionlib_msgs::GoalStatusArray& msg);
  void onFeedback(const ActionFeedback& msg);
  void onResult(const ActionResult& msg);

  std::string name_;
  OperatorLog log_;
  actionlib::GoalIDGenerator ids_;
  mutable std::mutex mutex_;  ///< guards the two that follow
  std::string own_id_;        ///< empty: none, or it has ended
  teleop::ActionView view_;
  ros::Publisher goal_publisher_, cancel_publisher_;
  ros::Subscriber status_subscriber_;
};

using PatrolLink = ActionLink<PatrolAction>;
using SpinLink = ActionLink<SpinAction>;

}  // namespace frontier_pilot
