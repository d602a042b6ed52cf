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

/// Inputs of a recovery, in the map frame.
struct RecoveryInputs {
  Pose2 T_map_base;
  ScanDistance scan_distance;  ///< of the latest scan; valid in this tick only
};

struct RecoveryStep {
  Twist2 command;
  bool done = false;  ///< finished, or no further motion is possible; the command is zero
};

/// A recovery under way: called once a tick until it is done.
using Recovery = std::function<RecoveryStep(const RecoveryInputs&, Time now)>;

/// A rung of the ladder [NAV-3]: its name in the status, whether it also removes the live obstacles, and a function
/// that begins it. Plain callables, so that any timed behaviour can be used.
struct RecoveryRung {
  std::string name;
  bool clears_obstacles = false;
  std::function<Recovery()> begin;  ///< empty: no motion
};

/// A ladder without motions: it only removes the live obstacles. system/behavior_ladder.h combines this with motions.
std::vector<RecoveryRung> clearingLadder();

}  // namespace frontier_pilot::navigation
