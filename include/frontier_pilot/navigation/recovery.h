#pragma once

#include <functional>
#include <string>
#include <vector>

#include "frontier_pilot/core/geometry.h"
#include "frontier_pilot/core/parameters.h"
#include "frontier_pilot/core/time.h"
#include "frontier_pilot/navigation/scan_points.h"

namespace frontier_pilot::navigation {

/// What a recovery sees; map frame.
struct RecoveryInputs {
  Pose2 T_map_base;
  const ScanPoints& scan;
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

/// What the driving rungs do.
struct RecoveryParams {
  double back_up_distance = 0.2;  ///< [m]
  double back_up_speed = 0.08;    ///< [m/s]
  double spin_angle = 2.0 * kPi;  ///< [rad]
  double spin_rate = 1.0;         ///< [rad/s]
  double time_allowance = 10.0;   ///< for each [s]
  double margin = 0.015;          ///< room that the outline keeps meanwhile [m]

  template <class Visitor>
  void describe(Visitor& v) {
    v.field("back_up_distance", back_up_distance, "m", "distance that a blocked robot backs up", positive());
    v.fixed({"back_up_speed"});
    v.field("spin_angle", spin_angle, "rad", "angle that a blocked robot turns to look around", positive());
    v.fixed({"spin_rate"});
    v.field("time_allowance", time_allowance, "s", "a recovery that takes longer is ended", timeSpan());
    v.field("margin", margin, "m", "room that the robot's outline keeps to the scan's points while it recovers",
            between(0.0, 0.5));
    v.moved("footprint_radius", "margin, on top of the robot's outline");
  }
};

/// Only what needs no motion: forgetting the live obstacles. Motions are put together with it by whoever owns both, see
/// system/behavior_ladder.h.
std::vector<RecoveryRung> clearingLadder();

}  // namespace frontier_pilot::navigation
