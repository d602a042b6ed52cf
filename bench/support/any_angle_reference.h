#pragma once

#include "frontier_pilot/planning/clearance_map.h"
#include "frontier_pilot/planning/path.h"

namespace frontier_pilot::bench {

/// What the planner's paths are measured against: a very nearly shortest any-angle path of the same clearance, at any
/// cost. A* over 32 directions with exact lines of sight, then string pulling over all points until nothing is gained.
/// `map` should have a wall weight of 0. The shortest path of 32 directions is at most 1.014 times the any-angle one in
/// the open (the worst angle between neighbouring directions is half of 18.4 degrees), so length / 1.014 of the search
/// bounds the true optimum from below, up to the cells' raster.
struct AnyAngleReference {
  planning::Path path;       ///< empty if there is none
  double lower_bound = 0.0;  ///< [m]
};
AnyAngleReference shortestAnyAngle(const planning::ClearanceMap& map, const Vec2& start, const Vec2& goal);

}  // namespace frontier_pilot::bench
