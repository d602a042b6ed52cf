#include "frontier_pilot/core/robot.h"

#include <algorithm>

namespace frontier_pilot {
namespace {

double approach(double target, double from, double step) { return std::clamp(target, from - step, from + step); }

}  // namespace

Twist2 clamp(const Twist2& twist, const RobotLimits& limits) {
  return {std::clamp(twist.linear, -limits.max_linear, limits.max_linear),
          std::clamp(twist.angular, -limits.max_angular, limits.max_angular)};
}

Twist2 limitAcceleration(const Twist2& target, const Twist2& from, const RobotLimits& limits, double seconds) {
  return {approach(target.linear, from.linear, limits.max_linear_acc * seconds),
          approach(target.angular, from.angular, limits.max_angular_acc * seconds)};
}

}  // namespace frontier_pilot
