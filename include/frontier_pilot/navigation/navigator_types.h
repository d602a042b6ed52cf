#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "frontier_pilot/core/geometry.h"
#include "frontier_pilot/core/laser_scan.h"
#include "frontier_pilot/core/motion.h"
#include "frontier_pilot/core/time.h"

namespace frontier_pilot::navigation {

/// A place to go to. `T_map_goal.yaw` matters only with `use_yaw`.
struct NavGoal {
  std::uint64_t id = 0;  ///< chosen by the caller; returned in the result
  Pose2 T_map_goal;
  bool use_yaw = false;
};

/// Inputs of one tick. A missing input is absent; an old one is recognised by its stamp.
struct NavigatorInputs {
  std::optional<StampedPose2> pose;  ///< T_map_base
  const LaserScan2* scan = nullptr;  ///< the latest one; processed once per stamp
  bool map_alive = true;             ///< false: the map's publisher is gone, so the map may be out of date
  Twist2 twist;                      ///< current one, from odometry
  std::optional<NavGoal> new_goal;   ///< an event: preempts the current goal
  bool cancel = false;               ///< an event; acts before `new_goal`
};

enum class NavState { kIdle, kDriving, kTurning, kRecovering, kWaiting };
const char* toString(NavState state);

/// Why the navigator does what it does, or why a goal ended.
enum class NavReason {
  kNone,
  kDriving,
  kTurning,
  kReached,
  kPreempted,
  kCanceled,
  kNoMap,
  kNoPose,
  kNoScan,
  kInvalidGoal,
  kGoalOutside,
  kGoalOccupied,
  kGoalUnreachable,
  kNoPath,
  kStartOutside,
  kStartBlocked,
  kBlocked,
  kOscillating,
  kClockJumped,
};
/// The text of results and status, e.g. "goal occupied".
const char* toString(NavReason reason);

enum class NavResult { kSucceeded, kPreempted, kCanceled, kAborted };
const char* toString(NavResult result);

struct NavFinished {
  std::uint64_t id = 0;
  NavResult result = NavResult::kAborted;
  NavReason reason = NavReason::kNone;
};

struct NavigatorOutput {
  /// To be published; absent while there is no goal. Zero in every tick in which a goal ends and none follows. [NAV-1]
  std::optional<Twist2> command;
  NavState state = NavState::kIdle;
  NavReason reason = NavReason::kNone;
  std::string recovery;               ///< what the recovery in progress is doing [NAV-3]
  std::vector<NavFinished> finished;  ///< goals that ended in this tick, the oldest first
  bool plan_changed = false;          ///< `Navigator::path` has been replaced or is no longer followed
};

}  // namespace frontier_pilot::navigation
