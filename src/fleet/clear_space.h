#pragma once

#include "frontier_pilot/core/grid.h"

namespace frontier_pilot::fleet {

/// Whether `grid` knows nothing but free space for MergedMap::kClearance around `cell`.
bool isClearAround(const OccupancyGrid& grid, Cell cell);

/// MergedMap::kClearance in cells of `resolution` [m].
int clearanceCells(double resolution);

}  // namespace frontier_pilot::fleet
