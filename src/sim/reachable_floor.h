#pragma once

#include <cstdint>

#include "frontier_pilot/core/grid.h"

namespace frontier_pilot::sim {

/// 1 for every cell of a true map that is not free, 0 for the others.
Grid<std::uint8_t> notFree(const OccupancyGrid& truth);

/// 1 for every cell that can be reached from `start` by steps between 4-neighbours which are not `blocked`. All 0 when
/// `start` is blocked or outside.
Grid<std::uint8_t> connectedCells(const Grid<std::uint8_t>& blocked, Cell start);

/// 1 for every free cell that a disc of `radius_cells` (Euclidean, in cells) covers while its centre moves from `start`
/// between 4-neighbours wherever it fits. It fits where all cells within `radius_cells` are free; the outside of the
/// grid does not count as a wall. Linear in the number of cells. All 0 when the disc does not fit at `start`.
Grid<std::uint8_t> reachableFloor(const OccupancyGrid& truth, Cell start, int radius_cells);

}  // namespace frontier_pilot::sim
