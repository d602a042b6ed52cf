#include "exploration/tour/unknown_region.h"

#include <cstdint>
#include <vector>

#include "frontier_pilot/grids/cell_search.h"

namespace frontier_pilot::exploration {

double unknownAreaBehind(const OccupancyGrid& map, Cell frontier, double radius) {
  const int reach = static_cast<int>(radius / map.resolution());
  grids::CellWindow<std::uint8_t> seen(frontier, reach, 0);
  std::vector<Cell> open;
  const auto visit = [&](Cell c) {
    const int dx = c.x - frontier.x, dy = c.y - frontier.y;
    if (dx * dx + dy * dy > reach * reach || !map.contains(c) || !isUnknown(map[c]) || seen[c] != 0) return;
    seen[c] = 1;
    open.push_back(c);
  };
  for (const Cell step : grids::kNeighbourSteps) visit({frontier.x + step.x, frontier.y + step.y});
  for (std::size_t next = 0; next != open.size();) {
    const Cell c = open[next++];
    visit({c.x + 1, c.y});
    visit({c.x - 1, c.y});
    visit({c.x, c.y + 1});
    visit({c.x, c.y - 1});
  }
  return static_cast<double>(open.size()) * map.resolution() * map.resolution();
}

}  // namespace frontier_pilot::exploration
