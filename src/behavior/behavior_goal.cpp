#include <cmath>

#include "frontier_pilot/behavior/timed_behavior.h"

/// What is asked of a behaviour, and what became of it.
namespace frontier_pilot::behavior {

const char* toString(BehaviorKind kind) {
  constexpr const char* kNames[] = {"spin", "back_up", "drive_on_heading", "wait"};
  return kNames[static_cast<int>(kind)];
}

const char* toString(BehaviorOutcome outcome) {
  constexpr const char* kNames[] = {"idle",         "running",     "succeeded",
                                    "timeout",      "pose lost",   "collision ahead",
                                    "invalid goal", "no progress", "canceled"};
  return kNames[static_cast<int>(outcome)];
}

std::optional<std::string> problemOf(const BehaviorGoal& goal) {
  constexpr double kFarthest = 1e4;  // [m, rad]: from some 1e14 on a step of the robot would be lost in rounding
  if (!std::isfinite(goal.target)) return "invalid goal: the target is not finite";
  if (goal.kind != BehaviorKind::kWait && std::abs(goal.target) > kFarthest) {
    return "invalid goal: the target is farther than 10 km or 10,000 radians";
  }
  if (!(goal.time_allowance >= 0.0 && std::isfinite(goal.time_allowance))) {
    return "invalid goal: the time allowance must not be negative";
  }
  if (!(goal.speed >= 0.0 && std::isfinite(goal.speed))) return "invalid goal: the speed must be finite, not negative";
  if (goal.kind == BehaviorKind::kBackUp && goal.target < 0.0) {
    return "invalid goal: the distance to back up must not be negative";
  }
  if (goal.kind == BehaviorKind::kWait && goal.target < 0.0) return "invalid goal: the time must not be negative";
  return std::nullopt;
}

}  // namespace frontier_pilot::behavior
