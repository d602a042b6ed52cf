#pragma once

#include <cstdint>

#include "frontier_pilot/core/grid.h"

namespace frontier_pilot::sim {

/// Non-zero where robots and beams are stopped: in occupied cells, in unknown ones unless `unknown_is_free`, and in a
/// ring of one cell around `map`, where the world ends.
Grid<std::uint8_t> solidCells(const OccupancyGrid& map, bool unknown_is_free);

}  // namespace frontier_pilot::sim
