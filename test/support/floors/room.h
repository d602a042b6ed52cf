#pragma once

#include "frontier_pilot/core/grid.h"

namespace frontier_pilot::test {

/// A room of 6 m x 3 m with walls of 0.1 m, in cells of 5 cm; the map begins at the origin.
inline OccupancyGrid room() {
  OccupancyGrid map(GridGeometry{0.05, Vec2::Zero(), 124, 64}, kOccupied);
  for (int y = 2; y < 62; ++y) {
    for (int x = 2; x < 122; ++x) map[Cell{x, y}] = kFree;
  }
  return map;
}

}  // namespace frontier_pilot::test
