#pragma once

#include <vector>

#include "frontier_pilot/planning/clearance_map.h"

namespace frontier_pilot::planning {

/// A path to a passable cell for a robot that stands too near an obstacle or on an unknown cell.
struct InflationExit {
  double cost = 0.0;
  std::vector<Cell> cells;  ///< from the robot's cell to the passable one
};

/// The paths out of `from`, the cheapest first: one to each passable cell that is the first on its path, at most
/// `radius` [m] away. They avoid obstacles' vicinity and never cross an obstacle, except under the robot itself, where
/// none can be. A passable `from` gives one path, which is that cell alone. With `beyond`, paths continue through
/// passable cells to every one within the radius, for a robot on an island of cells that noise has cut off.
std::vector<InflationExit> findInflationExits(const ClearanceMap& map, Cell from, double radius, bool beyond = false);

}  // namespace frontier_pilot::planning
