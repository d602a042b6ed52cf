#include <algorithm>

#include "frontier_pilot/ros/behavior_actions.h"

namespace frontier_pilot {

BehaviorGoal toBehaviorGoal(const SpinGoal& goal) {
  return {BehaviorKind::kSpin, goal.target_yaw, 0.0, goal.time_allowance.toSec(), goal.disable_collision_checks == 0};
}

BehaviorGoal toBehaviorGoal(const BackUpGoal& goal) {
  return {BehaviorKind::kBackUp, goal.target_distance, goal.speed, goal.time_allowance.toSec(),
          goal.disable_collision_checks == 0};
}

BehaviorGoal toBehaviorGoal(const DriveOnHeadingGoal& goal) {
  return {BehaviorKind::kDriveOnHeading, goal.target_distance, goal.speed, goal.time_allowance.toSec(),
          goal.disable_collision_checks == 0};
}

BehaviorGoal toBehaviorGoal(const WaitGoal& goal) {
  return {BehaviorKind::kWait, goal.time.toSec(), 0.0, goal.time_allowance.toSec(), true};
}

std::uint16_t errorCode(BehaviorKind kind, BehaviorOutcome outcome) {
  if (outcome == BehaviorOutcome::kSucceeded) return 0;
  const int reason = static_cast<int>(outcome) - static_cast<int>(BehaviorOutcome::kTimeout) + 1;
  return static_cast<std::uint16_t>(700 + 100 * static_cast<int>(kind) + reason);
}

void fillResult(const BehaviorOutput& output, SpinResult& result) {
  result.angular_distance_traveled = static_cast<float>(output.progress);
}

void fillResult(const BehaviorOutput& output, BackUpResult& result) {
  result.distance_traveled = static_cast<float>(output.progress);
}

void fillResult(const BehaviorOutput& output, DriveOnHeadingResult& result) {
  result.distance_traveled = static_cast<float>(output.progress);
}

void fillResult(const BehaviorOutput&, WaitResult&) {}

void fillFeedback(const BehaviorOutput& output, const BehaviorGoal&, SpinFeedback& feedback) {
  feedback.angular_distance_traveled = static_cast<float>(output.progress);
}

void fillFeedback(const BehaviorOutput& output, const BehaviorGoal&, BackUpFeedback& feedback) {
  feedback.distance_traveled = static_cast<float>(output.progress);
}

void fillFeedback(const BehaviorOutput& output, const BehaviorGoal&, DriveOnHeadingFeedback& feedback) {
  feedback.distance_traveled = static_cast<float>(output.progress);
}

void fillFeedback(const BehaviorOutput& output, const BehaviorGoal& goal, WaitFeedback& feedback) {
  feedback.time_left = toRosDuration(std::max(0.0, goal.target - output.progress));
}

}  // namespace frontier_pilot
