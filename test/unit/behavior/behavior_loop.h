#pragma once

#include <algorithm>
#include <cmath>

#include "frontier_pilot/behavior/collision_check.h"
#include "frontier_pilot/behavior/timed_behavior.h"
#include "support/kinematic_base.h"

namespace frontier_pilot::test {

/// A behaviour, a base without noise, a world of points, a scanner that sees them, and the loop around them.
class BehaviorLoop {
 public:
  explicit BehaviorLoop(double frequency = 10.0, const RobotLimits& limits = {}, const Pose2& start = {})
      : base(start, limits), behavior(parameters(frequency)), period_(1.0 / frequency) {}

  static behavior::BehaviorParameters parameters(double frequency) {
    behavior::BehaviorParameters p;
    p.frequency = frequency;
    return p;
  }

  behavior::BehaviorOutput start(const behavior::BehaviorGoal& goal) { return behavior.start(goal, base.now()); }
  /// One cycle; `wheels`, if given, replaces the command on its way to the base.
  behavior::BehaviorOutput cycle(const std::optional<Twist2>& wheels = std::nullopt) {
    if (scanning) surroundings.insert(scan(), base.pose());
    if (posing) inputs.pose = StampedPose2{base.now(), base.pose()};
    inputs.look_ahead = surroundings.lookAhead(0.5, base.now());
    const behavior::BehaviorOutput output = behavior.update(inputs, base.now());
    const Twist2 command = output.command.value_or(Twist2());
    if (!command.isZero()) moved = true;
    base.run(wheels ? *wheels : command, period_);
    return output;
  }
  behavior::BehaviorOutput run(double seconds, const std::optional<Twist2>& wheels = std::nullopt) {
    behavior::BehaviorOutput output;
    const Time limit = base.now() + fromSeconds(seconds);
    do output = cycle(wheels);
    while (behavior.active() && base.now() < limit);
    return output;
  }
  /// Lets the base come to rest.
  void rest() { base.run({}, 1.0); }

  /// Beams of a quarter of a degree, 3 m long, from the base's origin; a point stops the beam next to it.
  LaserScan2 scan() const {
    LaserScan2 out;
    out.stamp = base.now();
    out.angle_min = -kPi;
    out.angle_increment = 2.0 * kPi / 1440.0;
    out.range_min = 0.05;
    out.range_max = 3.0;
    out.ranges.assign(1440, std::numeric_limits<float>::infinity());
    for (const Vec2& point : points) {
      const Vec2 seen = base.pose().inverse() * point;
      const auto beam = static_cast<std::size_t>(std::lround((bearing(seen) + kPi) / out.angle_increment)) % 1440;
      out.ranges[beam] = std::min(out.ranges[beam], static_cast<float>(seen.norm()));
    }
    return out;
  }

  KinematicBase base;
  behavior::TimedBehavior behavior;
  behavior::CollisionCheck surroundings;
  behavior::BehaviorInputs inputs;
  std::vector<Vec2> points;  ///< obstacles, in the odometry frame
  bool scanning = true;
  bool posing = true;
  bool moved = false;  ///< whether any command was not zero

 private:
  double period_;
};

}  // namespace frontier_pilot::test
