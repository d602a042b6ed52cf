#pragma once

#include "frontier_pilot/planning/clearance_map.h"
#include "frontier_pilot/planning/path.h"

namespace frontier_pilot::bench {

/// The reference for the planner's paths: a very nearly shortest any-angle path of the same clearance, computed without
/// regard to time. A* over 32 directions with exact lines of sight, then string pulling over all points until nothing
/// is gained. `map` should have a wall weight of 0. In the open, the shortest path of 32 directions is at most 1.014
/// times as long as the any-angle one (no direction is more than half of 18.4 degrees from one of them), so the length
/// found by A* over 1.014 is a lower bound of the optimum, up to the resolution of the cells.
struct AnyAngleReference {
  planning::Path path;       ///< empty if there is none
  double lower_bound = 0.0;  ///< [m]
};
AnyAngleReference shortestAnyAngle(const planning::ClearanceMap& map, const Vec2& start, const Vec2& goal);

}  // namespace frontier_pilot::bench
