#include <algorithm>

#include "ros/behavior_server/behavior_actions.h"

namespace frontier_pilot {

behavior::BehaviorGoal toBehaviorGoal(const SpinGoal& goal) {
  return {behavior::BehaviorKind::kSpin, goal.target_yaw, 0.0, goal.time_allowance.toSec(),
          goal.disable_collision_checks == 0};
}

behavior::BehaviorGoal toBehaviorGoal(const BackUpGoal& goal) {
  return {behavior::BehaviorKind::kBackUp, goal.target_distance, goal.speed, goal.time_allowance.toSec(),
          goal.disable_collision_checks == 0};
}

behavior::BehaviorGoal toBehaviorGoal(const DriveOnHeadingGoal& goal) {
  return {behavior::BehaviorKind::kDriveOnHeading, goal.target_distance, goal.speed, goal.time_allowance.toSec(),
          goal.disable_collision_checks == 0};
}

behavior::BehaviorGoal toBehaviorGoal(const WaitGoal& goal) {
  return {behavior::BehaviorKind::kWait, goal.time.toSec(), 0.0, goal.time_allowance.toSec(), true};
}

std::uint16_t errorCode(behavior::BehaviorKind kind, behavior::BehaviorOutcome outcome) {
  if (outcome == behavior::BehaviorOutcome::kSucceeded) return 0;
  const int reason = static_cast<int>(outcome) - static_cast<int>(behavior::BehaviorOutcome::kTimeout) + 1;
  return static_cast<std::uint16_t>(700 + 100 * static_cast<int>(kind) + reason);
}

void fillResult(const behavior::BehaviorOutput& output, SpinResult& result) {
  result.angular_distance_traveled = static_cast<float>(output.progress);
}

void fillResult(const behavior::BehaviorOutput& output, BackUpResult& result) {
  result.distance_traveled = static_cast<float>(output.progress);
}

void fillResult(const behavior::BehaviorOutput& output, DriveOnHeadingResult& result) {
  result.distance_traveled = static_cast<float>(output.progress);
}

void fillResult(const behavior::BehaviorOutput&, WaitResult&) {}

void fillFeedback(const behavior::BehaviorOutput& output, const behavior::BehaviorGoal&, SpinFeedback& feedback) {
  feedback.angular_distance_traveled = static_cast<float>(output.progress);
}

void fillFeedback(const behavior::BehaviorOutput& output, const behavior::BehaviorGoal&, BackUpFeedback& feedback) {
  feedback.distance_traveled = static_cast<float>(output.progress);
}

void fillFeedback(const behavior::BehaviorOutput& output, const behavior::BehaviorGoal&,
                  DriveOnHeadingFeedback& feedback) {
  feedback.distance_traveled = static_cast<float>(output.progress);
}

void fillFeedback(const behavior::BehaviorOutput& output, const behavior::BehaviorGoal& goal, WaitFeedback& feedback) {
  feedback.time_left = toRosDuration(std::max(0.0, goal.target - output.progress));
}

}  // namespace frontier_pilot
