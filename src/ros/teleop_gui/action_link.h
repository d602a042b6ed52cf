#pragma once

#include <actionlib/action_definition.h>
#include <actionlib/goal_id_generator.h>
#include <actionlib_msgs/GoalStatusArray.h>
#include <frontier_pilot/FollowWaypointsAction.h>
#include <frontier_pilot/PatrolAction.h>
#include <frontier_pilot/SpinAction.h>
#include <move_base_msgs/MoveBaseAction.h>
#include <ros/node_handle.h>

#include <mutex>
#include <optional>
#include <string>

#include "frontier_pilot/core/time.h"
#include "ros/common/node_connections.h"
#include "ros/teleop_gui/service_caller.h"

namespace frontier_pilot {

/// The operator's access to an action. Unlike a SimpleActionClient it shows and cancels the goals of all clients, not
/// only its own. May be used from any thread. For the actions below.
template <class Action>
class ActionLink {
 public:
  ACTION_DEFINITION(Action)

  /// Whose results are logged: those of all clients, or only those of the goals that were sent here.
  enum class Logs { kAll, kOwn };

  /// `name` is the action's name in the log.
  ActionLink(ros::NodeHandle& node, NodeConnections& connections, const std::string& action, std::string name,
             OperatorLog log, Logs logs = Logs::kAll);

  void start(const Goal& goal);
  /// Cancels all goals, whichever client sent them.
  void cancelAll();
  /// Cancels the goal that was sent here, if it may still be active, also if it has yet to arrive.
  void cancelOwn();
  /// The same only while the server has not shown the goal: an emergency stop ends one that has arrived, but not one
  /// that still waits in a link that is away.
  void cancelUnlessArrived();
  teleop::ActionView view() const;

 private:
  /// Whether the server shows the goal that was sent here. One that no longer does was started anew: the goal has died
  /// with the one before, and no result of it will come.
  enum class Shown { kNotYet, kYes, kNoLonger };

  void cancelById();
  void onStatus(const actionlib_msgs::GoalStatusArray& msg);
  void onFeedback(const ActionFeedback& msg);
  void onResult(const ActionResult& msg);

  std::string name_;
  OperatorLog log_;
  Logs logs_;
  actionlib::GoalIDGenerator ids_;
  mutable std::mutex mutex_;  ///< guards the four that follow
  std::string own_id_;        ///< of the goal sent here; empty if there is none or it has ended
  Shown shown_ = Shown::kNotYet;
  teleop::ActionView view_;
  std::optional<SteadyTime> heard_;  ///< when the server last sent its status
  ros::Publisher goal_publisher_, cancel_publisher_;
  ros::Subscriber status_subscriber_;
};

using PatrolLink = ActionLink<PatrolAction>;
using SpinLink = ActionLink<SpinAction>;
using WaypointsLink = ActionLink<FollowWaypointsAction>;
using NavigationLink = ActionLink<move_base_msgs::MoveBaseAction>;

}  // namespace frontier_pilot
