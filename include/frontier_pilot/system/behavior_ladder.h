#pragma once

#include <vector>

#include "frontier_pilot/behavior/timed_behavior.h"
#include "frontier_pilot/core/robot_model.h"
#include "frontier_pilot/navigation/parameters.h"
#include "frontier_pilot/navigation/recovery.h"

/// The navigator's recoveries out of the timed behaviours: what drives the actions back_up and spin drives these too.
/// The modules do not know each other, so they are put together here.
namespace frontier_pilot::system {

/// Looks ahead by the navigator's live scan: a motion is free unless it brings something into `outline`, the robot's
/// with its margin, or nearer to its middle than it is. A disc may always turn. What `scan_distance`
/// refers to must outlive it.
behavior::LookAhead lookAtScan(const navigation::ScanDistance& scan_distance, const Outline& outline);

/// The goal as far as it is free: a robot that is no disc may have room for a part of it only, and that may be enough
/// to turn. Of a disc's goals nothing is left out.
behavior::BehaviorGoal freePartOf(const behavior::BehaviorGoal& goal, const navigation::RecoveryInputs& in,
                                  const Outline& outline);

/// A recovery that does `goal` and is done when that ends, however it ends.
navigation::Recovery recoveryBy(const behavior::BehaviorGoal& goal, const behavior::BehaviorParameters& behavior,
                                const Outline& outline);

/// How the behaviours move as recoveries, ticked at `rate` [Hz].
behavior::BehaviorParameters recoveryBehavior(const navigation::RecoveryParams& params, const RobotLimits& limits,
                                              double rate);

/// Clear the local costmap, back up, spin; after the last rung there is only giving up. [NAV-3]
std::vector<navigation::RecoveryRung> behaviorLadder(const navigation::RecoveryParams& params, const RobotModel& robot,
                                                     double rate);

}  // namespace frontier_pilot::system
