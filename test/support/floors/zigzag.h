#pragma once

#include "frontier_pilot/core/grid.h"

namespace frontier_pilot::test {

/// A solid map with corridors of `width` cells of 5 cm: three metres along x, then two and a half along y, then along x
/// again, with a corner to the left and one to the right.
inline OccupancyGrid zigzag(int width) {
  OccupancyGrid map(GridGeometry{0.05, Vec2::Zero(), 120, 90}, kOccupied);
  const auto clear = [&](const CellRect& cells) {
    for (int y = cells.y; y < cells.y + cells.height; ++y) {
      for (int x = cells.x; x < cells.x + cells.width; ++x) map[Cell{x, y}] = kFree;
    }
  };
  clear({5, 10, 60, width});
  clear({65 - width, 10, width, 50});
  clear({65 - width, 60 - width, 60, width});
  return map;
}

}  // namespace frontier_pilot::test
