#pragma once

#include <optional>

#include "frontier_pilot/core/grid.h"

namespace frontier_pilot::map_files {

/// `map` with cells whose side is `resolution` [m] and the same lower left corner. A cell is occupied if one of the
/// cells that it overlaps is, otherwise free if one of them is: no wall is lost, and none gets a gap. Nothing if it
/// would have more than bounds::kMostMapCells cells.
std::optional<OccupancyGrid> resampled(const OccupancyGrid& map, double resolution);

}  // namespace frontier_pilot::map_files
