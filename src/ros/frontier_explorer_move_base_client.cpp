#include <utility>

#include "frontier_pilot/ros/conversions.h"
#include "frontier_pilot/ros/move_base_client.h"
#include "frontier_pilot/ros/names.h"

namespace frontier_pilot {
namespace {

GoalEvent::Kind kindOf(const actionlib::TerminalState& state) {
  using State = actionlib::TerminalState;
  switch (state.state_) {
    case State::SUCCEEDED:
      return GoalEvent::Kind::kReached;
    case State::REJECTED:
      return GoalEvent::Kind::kRejected;
    case State::PREEMPTED:
    case State::RECALLED:
      return GoalEvent::Kind::kPreempted;
    default:
      return GoalEvent::Kind::kAborted;
  }
}

}  // namespace

MoveBaseClient::MoveBaseClient(ros::NodeHandle& node) : client_(node, names::kMoveBase) {}

void MoveBaseClient::send(std::uint32_t goal_id, const Pose2& goal, const std::string& frame, Time now) {
  move_base_msgs::MoveBaseGoal msg;
  msg.target_pose = toPoseStampedMsg(goal, frame, now);
  client_.send(msg, [this, goal_id](const auto& state, const auto&) { handleDone(goal_id, state); });
  active_ = true;
}

void MoveBaseClient::cancel() {
  if (!active_) return;
  client_.cancel();
  client_.forget();
  active_ = false;
}

std::vector<GoalEvent> MoveBaseClient::takeEvents() { return std::exchange(events_, {}); }

void MoveBaseClient::handleDone(std::uint32_t goal_id, const actionlib::TerminalState& state) {
  active_ = false;
  const std::string text = state.getText().empty() ? state.toString() : state.getText();
  events_.push_back({goal_id, kindOf(state), text});
}

}  // namespace frontier_pilot
