#pragma once

#include <functional>
#include <string>
#include <vector>

#include "frontier_pilot/core/geometry.h"
#include "frontier_pilot/core/outline.h"
#include "frontier_pilot/core/time.h"

namespace frontier_pilot::navigation {

/// Distance [m] from the outline of a robot at `T_map_base` to the nearest point that the scan shows, negative inside
/// of the outline; large if there is none.
using ScanDistance = std::function<double(const Outline& outline, const Pose2& T_map_base)>;

/// What a recovery sees; map frame.
struct RecoveryInputs {
  Pose2 T_map_base;
  ScanDistance scan_distance;  ///< of the latest scan; valid in this tick only
};

struct RecoveryStep {
  Twist2 command;
  bool done = false;  ///< it did what it could; the command is zero then
};

/// A recovery under way: called once a tick until it is done.
using Recovery = std::function<RecoveryStep(const RecoveryInputs&, Time now)>;

/// A rung of the ladder [NAV-3]: what it says in the status, whether it also forgets live obstacles, and how it begins.
/// Plain callables, so that any timed behaviour fits in.
struct RecoveryRung {
  std::string name;
  bool clears_obstacles = false;
  std::function<Recovery()> begin;  ///< empty: nothing to drive
};

/// Only what needs no motion: forgetting the live obstacles. Motions are put together with it by whoever owns both, see
/// system/behavior_ladder.h.
std::vector<RecoveryRung> clearingLadder();

}  // namespace frontier_pilot::navigation
