#include "ros/patrol_client/patrol_client_adapter.h"

#include <iostream>
#include <ostream>
#include <string>

#include "ros/common/clock.h"
#include "ros/common/names.h"
#include "ros/common/publish_flush.h"

namespace frontier_pilot {
namespace {

constexpr Duration kPatience = std::chrono::milliseconds(1700);
constexpr Duration kNobodyThere = std::chrono::milliseconds(1000);  // the master takes a fraction of it to connect us
constexpr Duration kCancelPatience = std::chrono::seconds(5);

/// A line that a terminal does not take is dropped, but not those after it.
void write(std::ostream& stream, const std::string& line) {
  stream.clear();
  stream << line << std::endl;
}

void say(const std::string& text) { write(std::cout, text); }

}  // namespace

void PatrolClientAdapter::complain(const std::string& text) { write(std::cerr, "patrol_client: " + text); }

PatrolClientAdapter::PatrolClientAdapter(ros::NodeHandle& node, const patrol::PatrolOrder& order)
    : order_(order), client_(node, names::kPatrol), since_(steadyNow()), heard_(since_) {
  auto options = checkedSubscription<actionlib_msgs::GoalStatusArray>(names::kPatrolStatus, 1, unreadable_,
                                                                      [this](const auto&) { handleStatus(); });
  status_ = node.subscribe(options);
}

std::optional<patrol::PatrolExit> PatrolClientAdapter::update(int interrupts_so_far) {
  if (outcome_) return outcome_;
  return phase_ == Phase::kConnecting ? connect(interrupts_so_far) : watch(interrupts_so_far);
}

std::optional<patrol::PatrolExit> PatrolClientAdapter::connect(int interrupts_so_far) {
  if (interrupts_so_far > 0) return patrol::PatrolExit::kInterrupted;
  if (client_.isServerConnected()) {
    send();
    return std::nullopt;
  }
  const Duration waited = steadyNow() - since_;
  if (waited < (status_.getNumPublishers() > 0 ? 2 * kPatience : kNobodyThere)) return std::nullopt;
  complain(std::string("no patrol server answers on '") + names::kPatrol + "': is patrol_server running?");
  return patrol::PatrolExit::kNoServer;
}

void PatrolClientAdapter::send() {
  PatrolGoal msg;
  msg.goal.x = order_.mode;
  msg.goal.y = order_.size;
  msg.goal.z = order_.laps;
  phase_ = Phase::kRunning;
  since_ = heard_ = steadyNow();
  heard_ros_ = rosNow();
  client_.send(
      msg, [this](const auto& state, const auto& result) { handleDone(state, result); },
      [this](const auto& feedback) { handleFeedback(feedback); });
}

std::optional<patrol::PatrolExit> PatrolClientAdapter::watch(int interrupts_so_far) {
  if (serverLost()) {
    if (client_.isServerConnected()) cancel();  // one that only hangs would drive on when it wakes
    complain("the patrol server is gone; the robot stops because its commands expire");
    return patrol::PatrolExit::kNoServer;
  }
  if (interrupts_so_far > 0 && phase_ == Phase::kRunning) {
    say("stopping ...");
    cancel();
  }
  if (phase_ != Phase::kCanceling) return std::nullopt;
  if (interrupts_so_far < 2 && steadyNow() - since_ < kCancelPatience) return std::nullopt;
  complain("the server has not confirmed that it stopped");
  return patrol::PatrolExit::kInterrupted;
}

void PatrolClientAdapter::cancel() {
  client_.cancel();
  flushLastWords();
  phase_ = Phase::kCanceling;
  since_ = steadyNow();
}

bool PatrolClientAdapter::serverLost() {
  if (!client_.isServerConnected()) return true;
  // A server that hangs keeps its connections, but its status stops. The check in ROS time spares one that is silent
  // because the ROS clock stands still.
  return steadyNow() - heard_ > kPatience && rosNow() - heard_ros_ > std::chrono::seconds(1);
}

void PatrolClientAdapter::handleStatus() {
  heard_ = steadyNow();
  heard_ros_ = rosNow();
}

void PatrolClientAdapter::handleFeedback(const PatrolFeedbackConstPtr& feedback) {
  say(feedback->state + " of " + std::to_string(patrol::legsOf(order_)));
}

void PatrolClientAdapter::handleDone(const actionlib::TerminalState& state, const PatrolResultConstPtr& result) {
  using State = actionlib::TerminalState;
  const bool told = result && !result->result.empty();
  say(told ? result->result : state.getText());
  if (state == State::SUCCEEDED) {
    outcome_ = patrol::PatrolExit::kCompleted;
  } else {
    outcome_ = phase_ == Phase::kCanceling ? patrol::PatrolExit::kInterrupted : patrol::PatrolExit::kAborted;
  }
}

}  // namespace frontier_pilot
