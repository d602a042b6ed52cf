#pragma once

#include <cstdint>

#include "frontier_pilot/core/grid.h"

namespace frontier_pilot::sim {

/// 1 where the floor can be reached: the free cells that a disc of `radius_cells` (a Euclidean radius between cells)
/// covers while its centre moves from `start` over 4-neighbours wherever it fits; no disc comes within `radius_cells`
/// of a cell that is not free. Cells beyond the border do not count as walls. Linear in the number of cells.
/// All 0 when the disc does not fit at `start`.
Grid<std::uint8_t> reachableFloor(const OccupancyGrid& truth, Cell start, int radius_cells);

}  // namespace frontier_pilot::sim
