#pragma once

#include <vector>

#include "frontier_pilot/planning/clearance_map.h"

namespace frontier_pilot::planning {

/// A way for a robot that stands too near an obstacle, or where the map says unknown, to a passable cell.
struct InflationExit {
  double cost = 0.0;
  std::vector<Cell> cells;  ///< from the robot's cell to the passable one
};

/// The ways out of `from`, the cheapest first: one for each passable cell that is the first on its way, at most
/// `radius` [m] away. They shun nearness and never cross an obstacle, except for what lies under the robot itself,
/// which cannot be there. A passable `from` gives the one way that is itself; with `beyond` ways go on through passable
/// cells, to every one within the radius: for a robot on an island that noise has cut off.
std::vector<InflationExit> findInflationExits(const ClearanceMap& map, Cell from, double radius, bool beyond = false);

}  // namespace frontier_pilot::planning
