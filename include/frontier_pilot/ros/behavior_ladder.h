#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "frontier_pilot/behavior/timed_behavior.h"
#include "frontier_pilot/core/robot_model.h"
#include "frontier_pilot/planning/recovery.h"

/// The navigator's recoveries out of the timed behaviours: what drives the actions back_up and spin drives these too.
/// Modules do not know each other, so they are put together here; ROS itself is not needed for it.
namespace frontier_pilot {

/// Looks ahead by the navigator's live scan: a motion is free unless it brings something into `outline`, the robot's
/// with its margin, or nearer to its middle than it is. A disc may always turn. `scan` must outlive it.
inline LookAhead lookAtScan(const ScanPoints& scan, const Outline& outline) {
  return [&scan, outline](const Pose2& T_map_base, const AxisMotion& motion) {
    if (motion.axis == AxisMotion::Axis::kTurn && outline.isDisc()) return SweepResult::kClear;
    constexpr double kStep = 0.03;  // that the farthest point of the outline moves at most between two poses [m]
    const bool turns = motion.axis == AxisMotion::Axis::kTurn;
    const double travel = std::abs(motion.amount) * (turns ? outline.circumscribedRadius() : 1.0);
    const int poses = std::max(10, static_cast<int>(std::ceil(travel / kStep)));
    const double at_start = scan.distance(outline, T_map_base);
    // Along a wall other points of it, noisy as well, come up beside a straight outline.
    constexpr double kNoise = 0.005;  // [m]
    const double least = outline.isDisc() || at_start < -kNoise ? at_start : at_start - kNoise;
    for (int i = 1; i <= poses; ++i) {
      const double there = scan.distance(outline, T_map_base * motion.at(static_cast<double>(i) / poses));
      if (there < 0.0 && there < least) return SweepResult::kObstacle;
    }
    return SweepResult::kClear;
  };
}

/// The goal as far as it is free: a robot that is no disc may have room for a part of it only, and that may be enough
/// to turn. Of a disc's goals nothing is left out.
inline BehaviorGoal freePartOf(const BehaviorGoal& goal, const RecoveryInputs& in, const Outline& outline) {
  if (outline.isDisc()) return goal;
  const LookAhead look = lookAtScan(in.scan, outline);
  const double sign = goal.kind == BehaviorKind::kBackUp ? -1.0 : 1.0;
  const auto axis = goal.kind == BehaviorKind::kSpin ? AxisMotion::Axis::kTurn : AxisMotion::Axis::kLine;
  constexpr int kParts = 8;
  BehaviorGoal part = goal;
  for (int i = kParts; i > 1; --i) {
    part.target = goal.target * i / kParts;
    if (look(in.T_map_base, {axis, sign * part.target}) == SweepResult::kClear) break;
  }
  return part;
}

/// A recovery that does `goal` and is done when that ends, however it ends.
inline Recovery recoveryBy(const BehaviorGoal& goal, const BehaviorParameters& behavior, const Outline& outline) {
  return [goal, outline, core = TimedBehavior(behavior), begun = false](const RecoveryInputs& in, Time now) mutable {
    if (!begun) core.start(freePartOf(goal, in, outline), now);
    begun = true;
    BehaviorInputs inputs;
    inputs.pose = BehaviorInputs::Pose{now, in.T_map_base};
    inputs.look_ahead = lookAtScan(in.scan, outline);
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
inline std::vector<RecoveryRung> behaviorLadder(const RecoveryParams& params, const RobotModel& robot, double rate) {
  const BehaviorParameters behavior = recoveryBehavior(params, robot.limits, rate);
  const Outline outline = robot.drivenOutline().padded(params.margin);
  const BehaviorGoal back_up{BehaviorKind::kBackUp, params.back_up_distance, 0.0, params.time_allowance, true};
  const BehaviorGoal spin{BehaviorKind::kSpin, params.spin_angle, 0.0, params.time_allowance, true};
  return {{"clearing the local costmap", true, {}},
          {"backing up", false, [=] { return recoveryBy(back_up, behavior, outline); }},
          {"spinning", true, [=] { return recoveryBy(spin, behavior, outline); }}};
}

}  // namespace frontier_pilot
