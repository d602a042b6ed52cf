#pragma once

#include <memory>
#include <vector>

#include "frontier_pilot/core/grid.h"
#include "frontier_pilot/navigation/navigator_types.h"
#include "frontier_pilot/navigation/parameters.h"
#include "frontier_pilot/navigation/recovery.h"
#include "frontier_pilot/planning/clearance_map.h"
#include "frontier_pilot/planning/global_planner.h"
#include "frontier_pilot/planning/path.h"

namespace frontier_pilot::navigation {

/// Drives the robot to goals with move_base's semantics, as a state machine: [NAV-1] every goal ends in success,
/// preemption, cancellation or an abort that says why, with zero velocity; [NAV-2] the path is re-validated on every
/// change of map or live obstacles, local control looks at the live scan; [NAV-3] a robot that is stuck tries the
/// recoveries of a ladder in order; old or missing data stop it until they are back. Poses are T_map_base, velocities
/// in the base frame. A clock that jumps backward aborts the goal.
class Navigator {
 public:
  explicit Navigator(const NavigatorParams& params = {});
  Navigator(const NavigatorParams& params, std::vector<RecoveryRung> ladder);
  ~Navigator();
  Navigator(Navigator&&) noexcept;
  Navigator& operator=(Navigator&&) noexcept;
  Navigator(const Navigator&) = delete;
  Navigator& operator=(const Navigator&) = delete;

  /// Takes over a map: the differences inside `changed`, or all of it if its geometry is new.
  void setMap(const OccupancyGrid& map, const CellRect& changed);
  NavigatorOutput update(const NavigatorInputs& inputs, Time now);

  /// Other limits, clearance and tolerances, from the next update on. With another clearance the path is planned anew.
  /// A recovery that has begun ends as it began; `ladder` gives the next ones.
  void setParameters(const NavigatorParams& params, std::vector<RecoveryRung> ladder);

  /// Plans a path on the current map and live obstacles, for example for make_plan; pursuit of the goal is not
  /// affected.
  planning::PlanResult makePlan(const planning::PlanRequest& request);
  /// Removes the live obstacles that the scanner can see again, like move_base's clear_costmaps.
  void clearObstacles();

  bool hasGoal() const;
  /// Whether `path()` is one that is being followed.
  bool hasPath() const;
  /// The path being followed, or the last one; empty before the first.
  const planning::Path& path() const;
  /// What is left of the path being followed, with the robot's position first; empty while there is none.
  std::vector<Vec2> wayAhead() const;
  /// How far the robot has come along the path [m].
  double progress() const;
  /// Where the robot is expected to be over the follower's horizon, in the map's frame.
  const std::vector<Vec2>& prediction() const;
  const planning::ClearanceMap& clearanceMap() const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace frontier_pilot::navigation
