#include "fleet/clear_space.h"

#include <cmath>

#include "frontier_pilot/fleet/merged_map.h"

namespace frontier_pilot::fleet {

int clearanceCells(double resolution) { return static_cast<int>(std::ceil(MergedMap::kClearance / resolution - 1e-6)); }

bool isClearAround(const OccupancyGrid& grid, Cell cell) {
  const int radius = clearanceCells(grid.resolution());
  for (int y = cell.y - radius; y <= cell.y + radius; ++y) {
    for (int x = cell.x - radius; x <= cell.x + radius; ++x) {
      if (!isFree(grid.get({x, y}, kUnknown))) return false;
    }
  }
  return true;
}

}  // namespace frontier_pilot::fleet
