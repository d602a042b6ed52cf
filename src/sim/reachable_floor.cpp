#include "sim/reachable_floor.h"

#include <algorithm>
#include <cstdlib>
#include <vector>

namespace frontier_pilot::sim {
namespace {

// 1 within `radius` cells of a cell where `mask` is not 0. First each cell's distance to the nearest set cell in its
// column is found; then a cell is set if, d columns away, that distance is at most the disc's half height at d.
Grid<std::uint8_t> dilate(const Grid<std::uint8_t>& mask, int radius) {
  const int width = mask.width();
  const int height = mask.height();
  const int far = radius + 1;
  Grid<int> up_down(mask.geometry(), far);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const int before = y > 0 ? std::min(up_down[Cell{x, y - 1}] + 1, far) : far;
      up_down[Cell{x, y}] = mask[Cell{x, y}] != 0 ? 0 : before;
    }
  }
  for (int y = height - 2; y >= 0; --y) {
    for (int x = 0; x < width; ++x) {
      up_down[Cell{x, y}] = std::min(up_down[Cell{x, y}], up_down[Cell{x, y + 1}] + 1);
    }
  }
  std::vector<int> half_height;
  for (int d = 0; d <= radius; ++d) {
    int h = 0;
    while ((h + 1) * (h + 1) + d * d <= radius * radius) ++h;
    half_height.push_back(h);
  }
  Grid<std::uint8_t> grown(mask.geometry());
  for (int y = 0; y < height; ++y) {
    for (int d = -radius; d <= radius; ++d) {
      const int reach = half_height[static_cast<std::size_t>(std::abs(d))];
      for (int x = std::max(0, -d); x < width + std::min(0, -d); ++x) {
        grown[Cell{x, y}] |= static_cast<std::uint8_t>(up_down[Cell{x + d, y}] <= reach);
      }
    }
  }
  return grown;
}

}  // namespace

Grid<std::uint8_t> notFree(const OccupancyGrid& truth) {
  Grid<std::uint8_t> solid(truth.geometry());
  for (std::size_t i = 0; i < truth.size(); ++i) solid[i] = truth[i] != kFree ? 1 : 0;
  return solid;
}

Grid<std::uint8_t> connectedCells(const Grid<std::uint8_t>& blocked, Cell start) {
  Grid<std::uint8_t> reached(blocked.geometry());
  std::vector<Cell> open;
  const auto reach = [&](Cell cell) {
    if (blocked.get(cell, 1) != 0 || reached[cell] != 0) return;
    reached[cell] = 1;
    open.push_back(cell);
  };
  reach(start);
  while (!open.empty()) {
    const Cell cell = open.back();
    open.pop_back();
    for (const Cell next :
         {Cell{cell.x + 1, cell.y}, {cell.x - 1, cell.y}, {cell.x, cell.y + 1}, {cell.x, cell.y - 1}}) {
      reach(next);
    }
  }
  return reached;
}

Grid<std::uint8_t> reachableFloor(const OccupancyGrid& truth, Cell start, int radius_cells) {
  const Grid<std::uint8_t> not_free = notFree(truth);
  Grid<std::uint8_t> floor = dilate(connectedCells(dilate(not_free, radius_cells), start), radius_cells);
  for (std::size_t i = 0; i < floor.size(); ++i) {
    if (not_free[i] != 0) floor[i] = 0;
  }
  return floor;
}

}  // namespace frontier_pilot::sim
