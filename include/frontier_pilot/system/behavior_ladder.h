#pragma once

#include <vector>

#include "frontier_pilot/behavior/timed_behavior.h"
#include "frontier_pilot/core/motion.h"
#include "frontier_pilot/core/robot_model.h"
#include "frontier_pilot/navigation/parameters.h"
#include "frontier_pilot/navigation/recovery.h"

/// The navigator's recoveries, built from the timed behaviours that also carry out the actions back_up and spin. The
/// modules navigation and behavior do not depend on each other, so they are combined here.
namespace frontier_pilot::system {

/// Looks ahead in the navigator's live scan and in its map: a motion is free unless it brings a scan point into
/// `outline`, which is the robot's with a margin, or deeper into it than one is at the start, or leads where `in` says
/// that the robot has no room. A motion along a line must be free for `run_on` [m] beyond its end, where the base gets
/// to if its last command stays in force. A disc may always turn. What the functions in `in` refer to must outlive the
/// returned one.
behavior::LookAhead lookAround(const navigation::RecoveryInputs& in, const Outline& outline, double run_on);

/// A command after which no other comes.
struct LastCommand {
  double lifetime = 0.0;      ///< for how long the base follows it [s]
  double deceleration = 1.0;  ///< with which the base brakes then [m/s^2]

  /// How far it moves a base at `speed` [m].
  double runOn(double speed) const { return speed * lifetime + brakingDistance(speed, deceleration); }
};

/// The goal, shortened in eighths until it is free, but not below a quarter: there may be room for a part of the motion
/// only, and that may be enough. Where a quarter of a line is not free either, it is slower, so that a last command
/// needs less room (`kSpeedsOfRecovery`). A line leaves 2 cm for scans that show less room later.
behavior::BehaviorGoal freePartOf(const behavior::BehaviorGoal& goal, const navigation::RecoveryInputs& in,
                                  const Outline& outline, const LastCommand& last);

/// A recovery that carries out `goal` at the default speed or slower, and is done when the behaviour ends, whatever its
/// outcome. Each command along a line has room for `command_lifetime` [s] and braking, for it may be the last.
navigation::Recovery recoveryBy(behavior::BehaviorGoal goal, const behavior::BehaviorParameters& behavior,
                                const Outline& outline, double command_lifetime);

/// How the behaviours move as recoveries, ticked at `rate` [Hz].
behavior::BehaviorParameters recoveryBehavior(const navigation::RecoveryParams& params, const RobotLimits& limits,
                                              double rate);

/// Clear the local costmap, back up, spin; when none of them helps the navigator gives up. `rate` [Hz] is that of its
/// ticks. [NAV-3]
std::vector<navigation::RecoveryRung> behaviorLadder(const navigation::NavigatorParams& params, double rate);

}  // namespace frontier_pilot::system
