#pragma once

#include <vector>

#include "frontier_pilot/core/geometry.h"
#include "frontier_pilot/core/grid.h"

namespace frontier_pilot::bench {

/// What a tour must see, and with what.
struct TourTask {
  double radius = 0.15;  ///< of the disc that reaches the floor which counts, as of test::ExplorationMeter [m]
  double range = 8.0;    ///< of the scanner [m]
  double share = 0.99;   ///< of the reachable floor that must be seen
  int rounds = 400;      ///< of the search; more may find a shorter tour
};

/// A path from which nearly all of a floor is seen, for one who knows the floor.
struct OmniscientTour {
  std::vector<Vec2> path;  ///< corners from the start on, in the map's frame [m]
  double length = 0.0;     ///< [m]
  double seen = 0.0;       ///< share of the reachable floor that is seen on the path
};

/// A short path from `start`, with any end, from which at least the share of the reachable floor of `truth` is seen. It
/// is the watchman route problem with limited visibility, which is NP-hard: the length is an upper bound of the
/// optimum. The floor is seen in all directions at once, because turning on the spot costs no distance; therefore the
/// scanner's field of view does not matter. Deterministic. Throws std::invalid_argument when the disc does not fit at
/// the start.
OmniscientTour omniscientTour(const OccupancyGrid& truth, const Vec2& start, const TourTask& task);

}  // namespace frontier_pilot::bench
