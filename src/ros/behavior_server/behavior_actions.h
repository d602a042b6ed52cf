#pragma once

#include <frontier_pilot/BackUpAction.h>
#include <frontier_pilot/DriveOnHeadingAction.h>
#include <frontier_pilot/SpinAction.h>
#include <frontier_pilot/WaitAction.h>
#include <ros/node_handle.h>

#include <cstdint>
#include <functional>
#include <string>

#include "frontier_pilot/behavior/timed_behavior.h"
#include "ros/common/actions/action_server.h"

namespace frontier_pilot {

behavior::BehaviorGoal toBehaviorGoal(const SpinGoal& goal);
behavior::BehaviorGoal toBehaviorGoal(const BackUpGoal& goal);
behavior::BehaviorGoal toBehaviorGoal(const DriveOnHeadingGoal& goal);
behavior::BehaviorGoal toBehaviorGoal(const WaitGoal& goal);

/// The action's error code: 0 for success, otherwise its base (spin 700, back_up 800, drive_on_heading 900, wait 1000)
/// plus the number of the reason, from 1 on.
std::uint16_t errorCode(behavior::BehaviorKind kind, behavior::BehaviorOutcome outcome);

void fillResult(const behavior::BehaviorOutput& output, SpinResult& result);
void fillResult(const behavior::BehaviorOutput& output, BackUpResult& result);
void fillResult(const behavior::BehaviorOutput& output, DriveOnHeadingResult& result);
void fillResult(const behavior::BehaviorOutput& output, WaitResult& result);
void fillFeedback(const behavior::BehaviorOutput& output, const behavior::BehaviorGoal& goal, SpinFeedback& feedback);
void fillFeedback(const behavior::BehaviorOutput& output, const behavior::BehaviorGoal& goal, BackUpFeedback& feedback);
void fillFeedback(const behavior::BehaviorOutput& output, const behavior::BehaviorGoal& goal,
                  DriveOnHeadingFeedback& feedback);
void fillFeedback(const behavior::BehaviorOutput& output, const behavior::BehaviorGoal& goal, WaitFeedback& feedback);

/// One of the behaviour server's actions, independent of its message types.
class BehaviorPort {
 public:
  using Start = std::function<void(BehaviorPort&, const behavior::BehaviorGoal&)>;
  /// `why` says why the behaviour is ended from outside.
  using Cancel = std::function<void(const std::string& why)>;

  virtual ~BehaviorPort() = default;
  virtual void publishFeedback(const behavior::BehaviorOutput& output, const behavior::BehaviorGoal& goal) = 0;
  /// Sends the result; a zero velocity must have been published before.
  virtual void finish(const behavior::BehaviorOutput& output, const behavior::BehaviorGoal& goal) = 0;
  /// For /diagnostics: which requests were refused.
  virtual void report(diagnostic_updater::DiagnosticStatusWrapper& status) const = 0;
};

/// A port for one type of action. It is driven by the node's ticks and has no execute loop.
template <class Action, class Result, class Feedback>
class BehaviorActionPort : public BehaviorPort {
 public:
  /// `cancel` is called when the active goal is cancelled or replaced; in the latter case before `start`. It is also
  /// called when one that was cancelled before it came would have replaced the goal of any port.
  BehaviorActionPort(ros::NodeHandle& node, const char* name, const Start& start, const Cancel& cancel)
      : server_(
            node, name,
            [this, start](const typename SingleGoalServer<Action>::Goal& goal) { start(*this, toBehaviorGoal(goal)); },
            cancel) {}

  void publishFeedback(const behavior::BehaviorOutput& output, const behavior::BehaviorGoal& goal) override {
    Feedback feedback;
    fillFeedback(output, goal, feedback);
    server_.publishFeedback(feedback);
  }

  void finish(const behavior::BehaviorOutput& output, const behavior::BehaviorGoal& goal) override {
    Result result;
    result.total_elapsed_time = toRosDuration(output.elapsed);
    result.error_code = errorCode(goal.kind, output.outcome);
    result.error_msg = output.outcome == behavior::BehaviorOutcome::kSucceeded ? "" : output.message;
    fillResult(output, result);
    if (output.outcome == behavior::BehaviorOutcome::kSucceeded) return server_.setSucceeded(result, output.message);
    if (output.outcome == behavior::BehaviorOutcome::kCanceled) return server_.setPreempted(result, output.message);
    server_.setAborted(result, output.message);
  }

  void report(diagnostic_updater::DiagnosticStatusWrapper& status) const override { server_.report(status); }

 private:
  SingleGoalServer<Action> server_;
};

}  // namespace frontier_pilot
