#pragma once

#include <deque>
#include <functional>
#include <string>
#include <vector>

#include "frontier_pilot/core/geometry.h"
#include "frontier_pilot/core/outline.h"
#include "frontier_pilot/core/time.h"
#include "frontier_pilot/navigation/parameters.h"

namespace frontier_pilot::navigation {

/// Distance [m] from the outline of a robot at `T_map_base` to the nearest point that the scan shows, negative inside
/// of the outline; large if there is none.
using ScanDistance = std::function<double(const Outline& outline, const Pose2& T_map_base)>;

/// Whether a robot at `T_map_base` keeps off what the map shows, off what stands or moves on free floor, and off ground
/// that was never seen.
using HasRoom = std::function<bool(const Pose2& T_map_base)>;

/// Inputs of a recovery, in the map frame.
struct RecoveryInputs {
  Pose2 T_map_base;
  ScanDistance scan_distance;  ///< of the latest scan; valid in this tick only
  /// The way that the robot has come, the oldest pose first; nullptr if it is not known. Valid in this tick only.
  const std::deque<Pose2>* track = nullptr;
  bool can_turn = true;                    ///< whether the map leaves room to turn right round where the robot is
  std::function<bool()> path_exists = {};  ///< whether the planner finds a path from there; takes milliseconds
  /// Whether a pose keeps off the map and the live obstacles, at least as well as where the recovery began, lies on the
  /// robot's own side of whatever may move [MUL-3], and covers no new ground that neither the map nor the scan shows
  /// [NAV-4]; empty if there is no map. Valid in this tick only.
  HasRoom has_room = {};
};

struct RecoveryStep {
  Twist2 command;
  bool done = false;  ///< finished, or no further motion is possible; the command is zero
};

/// A recovery under way: called once a tick until it is done.
using Recovery = std::function<RecoveryStep(const RecoveryInputs&, Time now)>;

/// A rung of the ladder [NAV-3]: its name in the status, whether it also removes the live obstacles that the scanner
/// can see again, and a function that begins it. Plain callables, so that any timed behaviour can be used.
struct RecoveryRung {
  std::string name;
  bool clears_obstacles = false;
  std::function<Recovery()> begin;  ///< empty: no motion
};

/// Backs up along the way that the robot has come, for one that is not a disc and may stand where it cannot turn: by
/// `params.back_up_distance` and until it can turn or there is a path, as far as scan and map show room. The way ends
/// where the robot last turned on the spot; from there on, and if no way is known or none lies behind it, it backs up
/// straight. It ends when it has not moved by 0.1 m for `params.time_allowance`: the way out may be long. Pure pursuit
/// (Coulter, CMU-RI-TR-92-01, 1992), backwards. Each command has room for `command_lifetime` [s], for it may be the
/// last.
Recovery backOut(const RecoveryParams& params, const RobotModel& robot, double command_lifetime);

/// A ladder without motions: it only removes the live obstacles. system/behavior_ladder.h combines this with motions.
std::vector<RecoveryRung> clearingLadder();

}  // namespace frontier_pilot::navigation
