#pragma once

#include <cstdint>

#include "frontier_pilot/core/grid.h"

namespace frontier_pilot::exploration {

/// Writes to each cell of `window` the mask of its traversable neighbours. Bit i: the neighbour in direction i (0 east,
/// then counter-clockwise by 45 degrees) is traversable; 0 where the cell itself is not. `passable` holds 0xFF or 0.
void linkNeighbours(const Grid<std::uint8_t>& passable, const CellRect& window, Grid<std::uint8_t>& neighbours);

}  // namespace frontier_pilot::exploration
