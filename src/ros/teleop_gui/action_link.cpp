#include "ros/teleop_gui/action_link.h"

#include <algorithm>
#include <cmath>

#include "frontier_pilot/core/bounds.h"
#include "frontier_pilot/core/geometry.h"
#include "frontier_pilot/core/text.h"
#include "ros/common/clock.h"
#include "teleop/operator_state.h"

namespace frontier_pilot {
namespace {

bool isGoingOn(const actionlib_msgs::GoalStatus& status) {
  using Status = actionlib_msgs::GoalStatus;
  return status.status == Status::PENDING || status.status == Status::ACTIVE || status.status == Status::PREEMPTING ||
         status.status == Status::RECALLING;
}

std::string turned(double angle) { return "turned " + std::to_string(std::lround(angle * 180.0 / kPi)) + "°"; }

std::string textOf(const PatrolFeedback& feedback) { return feedback.state; }
std::string textOf(const PatrolResult& result) { return result.result; }
std::string textOf(const SpinFeedback& feedback) { return turned(feedback.angular_distance_traveled); }
std::string textOf(const SpinResult& result) {
  if (result.error_msg.empty()) return turned(result.angular_distance_traveled);
  const bool moved = std::lround(result.angular_distance_traveled * 180.0 / kPi) != 0;
  return (moved ? turned(result.angular_distance_traveled) : "Not turned") + ": " + result.error_msg;
}
std::string textOf(const FollowWaypointsFeedback& feedback) {
  return "on the way to waypoint " + std::to_string(feedback.current_waypoint + std::uint64_t{1});
}
std::string textOf(const FollowWaypointsResult& result) { return result.error_msg; }
std::string textOf(const move_base_msgs::MoveBaseFeedback&) { return {}; }
std::string textOf(const move_base_msgs::MoveBaseResult&) { return {}; }

}  // namespace

template <class Action>
ActionLink<Action>::ActionLink(ros::NodeHandle& node, NodeConnections& connections, const std::string& action,
                               std::string name, OperatorLog log, Logs logs)
    : name_(std::move(name)), log_(std::move(log)), logs_(logs) {
  const std::string goal = action + "/goal", cancel = action + "/cancel", status = action + "/status";
  const std::string feedback = action + "/feedback", result = action + "/result";
  goal_publisher_ = node.advertise<ActionGoal>(goal, 2);
  cancel_publisher_ = node.advertise<actionlib_msgs::GoalID>(cancel, 10);
  status_subscriber_ = connections.subscribe(status, 2, &ActionLink::onStatus, this);
  connections.subscribe(feedback, 10, &ActionLink::onFeedback, this);
  connections.subscribe(result, 10, &ActionLink::onResult, this);
}

template <class Action>
void ActionLink<Action>::start(const Goal& goal) {
  if (!view().server_up) return log_(teleop::Severity::kError, name_ + ": the server is down, or does not respond");
  ActionGoal msg;
  msg.goal_id = ids_.generateID();
  msg.header.stamp = msg.goal_id.stamp;
  msg.goal = goal;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    own_id_ = msg.goal_id.id;
    shown_ = Shown::kNotYet;
    view_.result.clear();
    view_.feedback.clear();
  }
  goal_publisher_.publish(msg);
  log_(teleop::Severity::kIdle, name_ + " requested");
}

template <class Action>
void ActionLink<Action>::cancelAll() {
  cancelOwn();                                          // may overtake its goal, which the empty id would not reach
  cancel_publisher_.publish(actionlib_msgs::GoalID());  // an empty id cancels all goals
  log_(teleop::Severity::kIdle, name_ + " stop requested");
}

template <class Action>
void ActionLink<Action>::cancelOwn() {
  const std::lock_guard<std::mutex> lock(mutex_);
  cancelById();
}

template <class Action>
void ActionLink<Action>::cancelUnlessArrived() {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (shown_ == Shown::kNotYet) cancelById();
}

template <class Action>
void ActionLink<Action>::cancelById() {
  if (own_id_.empty() || shown_ == Shown::kNoLonger) return;
  actionlib_msgs::GoalID id;
  id.id = own_id_;
  cancel_publisher_.publish(id);
}

template <class Action>
teleop::ActionView ActionLink<Action>::view() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  teleop::ActionView view = view_;
  // A server subscribes to goals and publishes status: another subscriber to the goals has no status, and a server that
  // died is disconnected from the goal topic at once. One that hangs sends no status, and would begin a goal when it
  // goes on, whenever that is.
  const bool heard = heard_ && steadyNow() - *heard_ <= fromSeconds(teleop::kStatusLifetime);
  view.connected = goal_publisher_.getNumSubscribers() > 0 && status_subscriber_.getNumPublishers() > 0;
  view.server_up = view.connected && heard;
  view.active = view.active && view.connected;
  view.own = view.active && !own_id_.empty() && shown_ != Shown::kNoLonger;
  return view;
}

template <class Action>
void ActionLink<Action>::onStatus(const actionlib_msgs::GoalStatusArray& msg) {
  const std::lock_guard<std::mutex> lock(mutex_);
  heard_ = steadyNow();
  view_.active = std::any_of(msg.status_list.begin(), msg.status_list.end(), isGoingOn);
  const auto own = std::find_if(msg.status_list.begin(), msg.status_list.end(),
                                [this](const auto& status) { return status.goal_id.id == own_id_; });
  if (own == msg.status_list.end()) {
    if (shown_ == Shown::kYes) shown_ = Shown::kNoLonger;
  } else if (own->status != actionlib_msgs::GoalStatus::RECALLING) {  // a cancel may be shown before its goal arrives
    shown_ = Shown::kYes;
  }
}

template <class Action>
void ActionLink<Action>::onFeedback(const ActionFeedback& msg) {
  const std::lock_guard<std::mutex> lock(mutex_);
  view_.feedback = printable(textOf(msg.feedback), bounds::kMostReason);
}

template <class Action>
void ActionLink<Action>::onResult(const ActionResult& msg) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const bool is_own = msg.status.goal_id.id == own_id_;
  if (is_own) own_id_.clear();
  const std::string text = textOf(msg.result);
  view_.result = printable(text.empty() ? msg.status.text : text, bounds::kMostReason);
  if (!is_own && logs_ == Logs::kOwn) return;
  const bool good = msg.status.status == actionlib_msgs::GoalStatus::SUCCEEDED;
  log_(good ? teleop::Severity::kGood : teleop::Severity::kWarning, name_ + ": " + view_.result);
}

template class ActionLink<PatrolAction>;
template class ActionLink<SpinAction>;
template class ActionLink<FollowWaypointsAction>;
template class ActionLink<move_base_msgs::MoveBaseAction>;

}  // namespace frontier_pilot
