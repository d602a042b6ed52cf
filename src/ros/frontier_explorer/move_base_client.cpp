#include <utility>

#include "frontier_pilot/navigation/navigator_types.h"
#include "ros/common/messages/conversions.h"
#include "ros/common/names.h"
#include "ros/frontier_explorer/move_base_client.h"

namespace frontier_pilot {
namespace {

/// The result of move_base has no field for the reason: the navigator says it in its text.
exploration::GoalEvent::Kind kindOf(const actionlib::TerminalState& state) {
  using State = actionlib::TerminalState;
  switch (state.state_) {
    case State::SUCCEEDED:
      return exploration::GoalEvent::Kind::kReached;
    case State::REJECTED:
      return exploration::GoalEvent::Kind::kRejected;
    case State::PREEMPTED:
    case State::RECALLED:
      return exploration::GoalEvent::Kind::kPreempted;
    case State::LOST:  // the server died and is there again: any other goal would have ended in the same way
      return exploration::GoalEvent::Kind::kUnable;
    default:
      return navigation::isNoFaultOfTheGoal(state.getText()) ? exploration::GoalEvent::Kind::kUnable
                                                             : exploration::GoalEvent::Kind::kAborted;
  }
}

std::string textOf(const actionlib::TerminalState& state) {
  // The text of a goal that was lost is one from before.
  if (state == actionlib::TerminalState::LOST) return "it does not know the goal any more";
  return state.getText().empty() ? state.toString() : state.getText();
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

std::vector<exploration::GoalEvent> MoveBaseClient::takeEvents() { return std::exchange(events_, {}); }

void MoveBaseClient::handleDone(std::uint32_t goal_id, const actionlib::TerminalState& state) {
  active_ = false;
  events_.push_back({goal_id, kindOf(state), textOf(state)});
}

}  // namespace frontier_pilot
