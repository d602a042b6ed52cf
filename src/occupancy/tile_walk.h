#pragma once

#include <cstddef>
#include <cstdint>

#include "frontier_pilot/core/grid.h"
#include "frontier_pilot/grids/growing_grid.h"
#include "frontier_pilot/occupancy/occupancy_map.h"

namespace frontier_pilot::occupancy {

using Tiles = grids::TiledGrid<float>;

/// Calls `visit` with the lower left cell of each tile that `cells`, counted from the frame's origin, touch.
template <class Visit>
void forEachTile(const CellRect& cells, const Visit& visit) {
  const CellRect whole = grids::snap(cells, Tiles::kSide);
  for (int y = whole.y; y < whole.y + whole.height; y += Tiles::kSide) {
    for (int x = whole.x; x < whole.x + whole.width; x += Tiles::kSide) visit(Cell{x, y});
  }
}

/// What OccupancyMap::value returns without probabilities. It has no branches, so that several cells are converted at
/// once.
inline std::int8_t trinary(float log_odds) {
  const int not_free = log_odds >= 0.0F ? 1 : 0;
  const int unknown = log_odds == kUnknownLogOdds ? 1 : 0;
  return static_cast<std::int8_t>(kOccupied * not_free + (kUnknown - kOccupied) * unknown);
}

/// The `i`-th cell of the tile whose lower left one is `low`.
inline Cell cellOf(Cell low, std::size_t i) {
  return {low.x + static_cast<int>(i % Tiles::kSide), low.y + static_cast<int>(i / Tiles::kSide)};
}

}  // namespace frontier_pilot::occupancy
