#include "behavior/motion_profile.h"

#include <algorithm>
#include <cmath>

#include "frontier_pilot/core/motion.h"

namespace frontier_pilot::behavior {
namespace {

/// How far a base at speed `rate` travels in `period` and in the stop after it, when the command is `speed`.
double anotherCycle(double rate, double speed, double acceleration, double period) {
  const double ramp = std::min(period, std::abs(speed - rate) / acceleration);
  const double end = speed > rate ? rate + acceleration * ramp : rate - acceleration * ramp;
  return 0.5 * (rate + end) * ramp + end * (period - ramp) + brakingDistance(end, acceleration);
}

}  // namespace

double MotionEstimate::present(double acceleration, double period) const {
  const double change = 0.5 * acceleration * period;
  return std::max(0.0, std::clamp(command, rate - change, rate + change));
}

ProfileStep profileStep(const MotionLimits& limits, double remaining, const MotionEstimate& estimate, double period) {
  const double rate = estimate.present(limits.acceleration, period);
  const double left = remaining - rate * estimate.age;
  const double wish = brakingSpeed(left - rate * period, limits.acceleration);
  const double speed = std::clamp(wish, limits.min_speed, limits.max_speed);
  const double stop_now = left - brakingDistance(rate, limits.acceleration);
  const double stop_later = left - anotherCycle(rate, speed, limits.acceleration, period);
  const bool nearer_now = stop_now <= 0.0 || (stop_later < 0.0 && stop_now <= -stop_later);
  // A base that stops sooner than assumed must not end far short of the target: first it is slowed to the least speed.
  const bool close = left <= brakingDistance(limits.min_speed, limits.acceleration) + 0.5 * limits.min_speed * period;
  const bool reached = remaining <= 0.0 || (nearer_now && close);
  return {reached, reached ? 0.0 : speed};
}

}  // namespace frontier_pilot::behavior
