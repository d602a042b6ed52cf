#include "frontier_pilot/system/behavior_ladder.h"

#include <algorithm>
#include <cmath>
#include <memory>

namespace frontier_pilot::system {

behavior::LookAhead lookAround(const navigation::RecoveryInputs& in, const Outline& outline, double run_on) {
  return [scan_distance = in.scan_distance, has_room = in.has_room, outline, run_on](const Pose2& T_map_base,
                                                                                     behavior::AxisMotion motion) {
    const bool turns = motion.axis == behavior::AxisMotion::Axis::kTurn;
    if (turns && outline.isDisc()) return behavior::SweepResult::kClear;
    if (!turns) motion.amount += std::copysign(run_on, motion.amount);
    constexpr double kStep = 0.03;  // [m]: how far a point of the outline may move between two poses
    const double travel = std::abs(motion.amount) * (turns ? outline.circumscribedRadius() : 1.0);
    const int poses = std::max(10, static_cast<int>(std::ceil(travel / kStep)));
    const double at_start = scan_distance(outline, T_map_base);
    // An outline with straight sides that moves along a wall meets other points of the wall, with other noise.
    constexpr double kNoise = 0.005;  // [m]
    const double least = outline.isDisc() || at_start < -kNoise ? at_start : at_start - kNoise;
    for (int i = 1; i <= poses; ++i) {
      const Pose2 pose = T_map_base * motion.at(static_cast<double>(i) / poses);
      const double there = scan_distance(outline, pose);
      if (there < 0.0 && there < least) return behavior::SweepResult::kObstacle;
      if (has_room && !has_room(pose)) return behavior::SweepResult::kObstacle;
    }
    return behavior::SweepResult::kClear;
  };
}

behavior::BehaviorGoal freePartOf(const behavior::BehaviorGoal& goal, const navigation::RecoveryInputs& in,
                                  const Outline& outline, const LastCommand& last) {
  const double sign = goal.kind == behavior::BehaviorKind::kBackUp ? -1.0 : 1.0;
  const auto axis = goal.kind == behavior::BehaviorKind::kSpin ? behavior::AxisMotion::Axis::kTurn
                                                               : behavior::AxisMotion::Axis::kLine;
  constexpr int kParts = 8;
  constexpr double kReserve = 0.02;  // [m]: later scans may show less room than this one
  behavior::BehaviorGoal part = goal;
  for (const double share : navigation::kSpeedsOfRecovery) {
    part.speed = share * goal.speed;
    const behavior::LookAhead look = lookAround(in, outline, last.runOn(part.speed) + kReserve);
    for (int i = kParts; i > 1; --i) {
      part.target = goal.target * i / kParts;
      if (look(in.T_map_base, {axis, sign * part.target}) == behavior::SweepResult::kClear) return part;
    }
    if (axis == behavior::AxisMotion::Axis::kTurn) break;  // whose room does not depend on the speed
  }
  return part;
}

navigation::Recovery recoveryBy(behavior::BehaviorGoal goal, const behavior::BehaviorParameters& behavior,
                                const Outline& outline, double command_lifetime) {
  const auto core = std::make_shared<behavior::TimedBehavior>(behavior);  // a std::function must be copyable
  const RobotLimits& limits = behavior.robot.limits;
  const LastCommand last{command_lifetime + 1.0 / behavior.frequency, limits.max_linear_acc};
  goal.speed = std::min(behavior.default_linear_vel, limits.max_linear);
  return [goal, outline, core, last, begun = false](const navigation::RecoveryInputs& in, Time now) mutable {
    if (!begun) core->start(freePartOf(goal, in, outline, last), now);
    begun = true;
    behavior::BehaviorInputs inputs;
    inputs.pose = StampedPose2{now, in.T_map_base};
    inputs.look_ahead = lookAround(in, outline, last.runOn(core->goal().speed));
    const behavior::BehaviorOutput output = core->update(inputs, now);
    return navigation::RecoveryStep{output.command.value_or(Twist2()), !core->active()};
  };
}

behavior::BehaviorParameters recoveryBehavior(const navigation::RecoveryParams& params, const RobotLimits& limits,
                                              double rate) {
  behavior::BehaviorParameters behavior;
  behavior.frequency = rate;
  behavior.robot.limits = limits;
  behavior.max_rotational_vel = params.spin_rate;
  behavior.min_rotational_vel = std::min(behavior.min_rotational_vel, behavior.max_rotational_vel);
  behavior.default_linear_vel = params.back_up_speed;
  return behavior;
}

std::vector<navigation::RecoveryRung> behaviorLadder(const navigation::NavigatorParams& params, double rate) {
  const RobotModel& robot = params.robot;
  const navigation::RecoveryParams& recovery = params.recovery;
  const behavior::BehaviorParameters behavior = recoveryBehavior(recovery, robot.limits, rate);
  const Outline outline = robot.drivenOutline().padded(recovery.margin);
  const behavior::BehaviorGoal back_up{behavior::BehaviorKind::kBackUp, recovery.back_up_distance, 0.0,
                                       recovery.time_allowance, true};
  const behavior::BehaviorGoal spin{behavior::BehaviorKind::kSpin, recovery.spin_angle, 0.0, recovery.time_allowance,
                                    true};
  const double lifetime = params.follower.command_lifetime;
  const auto backing_up = [=] {
    return robot.drivenOutline().isDisc() ? recoveryBy(back_up, behavior, outline, lifetime)
                                          : navigation::backOut(recovery, robot, lifetime);
  };
  return {{"clearing the local costmap", true, {}},
          {"backing up", false, backing_up},
          {"spinning", true, [=] { return recoveryBy(spin, behavior, outline, lifetime); }}};
}

}  // namespace frontier_pilot::system
