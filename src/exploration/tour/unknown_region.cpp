#include "exploration/tour/unknown_region.h"

#include <vector>

#include "frontier_pilot/grids/cell_search.h"

namespace frontier_pilot::exploration {
namespace {

constexpr double kRadius = 2.5;  // [m]

}  // namespace

std::vector<Cell> unknownBehind(const OccupancyGrid& map, Cell frontier, double radius, std::size_t most) {
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
  for (std::size_t next = 0; next != open.size() && open.size() < most;) {
    const Cell c = open[next++];
    visit({c.x + 1, c.y});
    visit({c.x - 1, c.y});
    visit({c.x, c.y + 1});
    visit({c.x, c.y - 1});
  }
  return open;
}

double UnknownRegions::areaBehind(Cell frontier, const ObservedMap& map) {
  constexpr std::size_t kMost = 20000;
  if (geometry_ != map.geometry() || regions_.size() > kMost) regions_.clear();
  geometry_ = map.geometry();
  const std::uint64_t changes = map.changesAround(map.geometry().centre(frontier), kRadius) + 1;
  const double cell_area = map.geometry().resolution * map.geometry().resolution;
  Region& region = regions_[map.geometry().index(frontier)];
  if (region.changes != changes) {
    const auto most = static_cast<std::size_t>(most_ / cell_area) + 1;
    region = {changes, static_cast<double>(unknownBehind(map.grid(), frontier, kRadius, most).size()) * cell_area};
  }
  return region.area;
}

}  // namespace frontier_pilot::exploration
