#include "frontier_pilot/ros/patrol_link.h"

#include <frontier_pilot/PatrolActionGoal.h>

#include <algorithm>

#include "frontier_pilot/ros/names.h"

namespace frontier_pilot {
namespace {

bool isGoingOn(const actionlib_msgs::GoalStatus& status) {
  using Status = actionlib_msgs::GoalStatus;
  return status.status == Status::PENDING || status.status == Status::ACTIVE || status.status == Status::PREEMPTING ||
         status.status == Status::RECALLING;
}

}  // namespace

PatrolLink::PatrolLink(ros::NodeHandle& node, OperatorLog log) : log_(std::move(log)) {
  const std::string action = std::string(names::kPatrol) + "/";
  const std::string goal = action + "goal", cancel = action + "cancel", status = action + "status";
  const std::string feedback = action + "feedback", result = action + "result";
  goal_publisher_ = node.advertise<PatrolActionGoal>(goal, 2);
  cancel_publisher_ = node.advertise<actionlib_msgs::GoalID>(cancel, 2);
  status_subscriber_ = node.subscribe(status, 2, &PatrolLink::onStatus, this);
  feedback_subscriber_ = node.subscribe(feedback, 10, &PatrolLink::onFeedback, this);
  result_subscriber_ = node.subscribe(result, 10, &PatrolLink::onResult, this);
}

void PatrolLink::start(int shape, double side, int laps) {
  if (!view().server_up) return log_(Severity::kError, "patrol: the server is down");
  PatrolActionGoal msg;
  msg.goal_id = ids_.generateID();
  msg.header.stamp = msg.goal_id.stamp;
  msg.goal.goal.x = shape;
  msg.goal.goal.y = side;
  msg.goal.goal.z = laps;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    own_id_ = msg.goal_id.id;
    view_.result.clear();
    view_.feedback.clear();
  }
  goal_publisher_.publish(msg);
  log_(Severity::kIdle, "patrol asked for");
}

void PatrolLink::cancelAll() {
  cancel_publisher_.publish(actionlib_msgs::GoalID());  // empty: all of them
  log_(Severity::kIdle, "patrol stop asked for");
}

void PatrolLink::cancelOwn() {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (own_id_.empty()) return;
  actionlib_msgs::GoalID id;
  id.id = own_id_;
  cancel_publisher_.publish(id);
  own_id_.clear();
}

PatrolView PatrolLink::view() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  PatrolView view = view_;
  // A listener that is no server has no status to tell; a server that died is off the goal topic at once.
  view.server_up = goal_publisher_.getNumSubscribers() > 0 && status_subscriber_.getNumPublishers() > 0;
  view.active = view.active && view.server_up;
  return view;
}

void PatrolLink::onStatus(const actionlib_msgs::GoalStatusArray& msg) {
  const std::lock_guard<std::mutex> lock(mutex_);
  view_.active = std::any_of(msg.status_list.begin(), msg.status_list.end(), isGoingOn);
}

void PatrolLink::onFeedback(const PatrolActionFeedback& msg) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (msg.feedback.state == view_.feedback) return;
  view_.feedback = msg.feedback.state;
  log_(Severity::kIdle, "patrol: " + view_.feedback);
}

void PatrolLink::onResult(const PatrolActionResult& msg) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (msg.status.goal_id.id == own_id_) own_id_.clear();
  view_.result = msg.result.result.empty() ? msg.status.text : msg.result.result;
  const bool good = msg.status.status == actionlib_msgs::GoalStatus::SUCCEEDED;
  log_(good ? Severity::kGood : Severity::kWarning, "patrol: " + view_.result);
}

}  // namespace frontier_pilot
