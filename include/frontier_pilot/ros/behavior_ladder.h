#pragma once

#include <algorithm>
#include <vector>

#include "frontier_pilot/behavior/timed_behavior.h"
#include "frontier_pilot/planning/recovery.h"

/// The navigator's recoveries out of the timed behaviours: what drives the actions back_up and spin drives these too.
/// Modules do not know each other, so they are put together here; ROS itself is not needed for it.
namespace frontier_pilot {

/// Looks ahead by the navigator's live scan and with its round footprint: a turn is always free, and a straight motion
/// is unless it brings the robot nearer to something than `radius` [m]. `scan` must outlive it.
inline LookAhead lookAtScan(const ScanPoints& scan, double radius) {
  return [&scan, radius](const Pose2& T_map_base, const AxisMotion& motion) {
    if (motion.axis == AxisMotion::Axis::kTurn) return SweepResult::kClear;
    constexpr int kPoses = 10;
    const double at_start = scan.distance(T_map_base.position());
    for (int i = 1; i <= kPoses; ++i) {
      const double there = scan.distance((T_map_base * motion.at(static_cast<double>(i) / kPoses)).position());
      if (there < radius && there < at_start) return SweepResult::kObstacle;
    }
    return SweepResult::kClear;
  };
}

/// A recovery that does `goal` and is done when that ends, however it ends.
inline Recovery recoveryBy(const BehaviorGoal& goal, const BehaviorParameters& behavior, double radius) {
  return [goal, radius, core = TimedBehavior(behavior), begun = false](const RecoveryInputs& in, Time now) mutable {
    if (!begun) core.start(goal, now);
    begun = true;
    BehaviorInputs inputs;
    inputs.pose = BehaviorInputs::Pose{now, in.T_map_base};
    inputs.look_ahead = lookAtScan(in.scan, radius);
    const BehaviorOutput output = core.update(inputs, now);
    return RecoveryStep{output.command.value_or(Twist2()), !core.active()};
  };
}

/// How the behaviours move as recoveries, ticked at `rate` [Hz].
inline BehaviorParameters recoveryBehavior(const RecoveryParams& params, const RobotLimits& limits, double rate) {
  BehaviorParameters behavior;
  behavior.frequency = rate;
  behavior.robot.limits = limits;
  behavior.max_rotational_vel = params.spin_rate;
  behavior.min_rotational_vel = std::min(behavior.min_rotational_vel, behavior.max_rotational_vel);
  behavior.default_linear_vel = params.back_up_speed;
  return behavior;
}

/// Clear the local costmap, back up, spin; after the last rung there is only giving up. [NAV-3]
inline std::vector<RecoveryRung> behaviorLadder(const RecoveryParams& params, const RobotLimits& limits, double rate) {
  const BehaviorParameters behavior = recoveryBehavior(params, limits, rate);
  const double radius = params.footprint_radius;
  const BehaviorGoal back_up{BehaviorKind::kBackUp, params.back_up_distance, 0.0, params.time_allowance, true};
  const BehaviorGoal spin{BehaviorKind::kSpin, params.spin_angle, 0.0, params.time_allowance, true};
  return {{"clearing the local costmap", true, {}},
          {"backing up", false, [=] { return recoveryBy(back_up, behavior, radius); }},
          {"spinning", true, [=] { return recoveryBy(spin, behavior, radius); }}};
}

}  // namespace frontier_pilot
