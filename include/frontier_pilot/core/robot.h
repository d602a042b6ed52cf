#pragma once

#include "frontier_pilot/core/geometry.h"
#include "frontier_pilot/core/parameters.h"

namespace frontier_pilot {

/// What a differential drive can do. Defaults: TurtleBot3 Burger (maker's data sheet).
struct RobotLimits {
  double max_linear = 0.22;      ///< [m/s], forward and in reverse
  double max_angular = 2.84;     ///< [rad/s]
  double max_linear_acc = 2.5;   ///< [m/s^2]
  double max_angular_acc = 3.2;  ///< [rad/s^2]

  template <class Visitor>
  void describe(Visitor& v) {
    v.field("max_linear", max_linear, "m/s", "greatest speed, forward and in reverse", positiveUpTo(20.0));
    v.field("max_angular", max_angular, "rad/s", "greatest rate of turn", positiveUpTo(50.0));
    v.field("max_linear_acc", max_linear_acc, "m/s^2", "greatest change of speed", positiveUpTo(1000.0));
    v.field("max_angular_acc", max_angular_acc, "rad/s^2", "greatest change of the rate of turn", positiveUpTo(1000.0));
  }
};

/// `twist` with each axis cut to the limits. Finite in, finite out.
Twist2 clamp(const Twist2& twist, const RobotLimits& limits);

/// The twist nearest to `target` that can be reached from `from` in `seconds` [s] under the acceleration limits.
Twist2 limitAcceleration(const Twist2& target, const Twist2& from, const RobotLimits& limits, double seconds);

}  // namespace frontier_pilot
