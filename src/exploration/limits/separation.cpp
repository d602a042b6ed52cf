#include "exploration/limits/separation.h"

#include <cstdint>
#include <vector>

#include "frontier_pilot/grids/cell_search.h"

namespace frontier_pilot::exploration {
namespace {

/// Whether a way over cells that are `passable` leads from one cell to the other; both of these count as passable.
template <class Passable>
bool connected(const GridGeometry& geometry, Cell from, Cell to, const Passable& passable) {
  Grid<std::uint8_t> seen(geometry, 0);
  std::vector<Cell> open{from};
  while (!open.empty()) {
    const Cell cell = open.back();
    open.pop_back();
    if (cell == to) return true;
    for (const Cell step : grids::kNeighbourSteps) {
      const Cell next{cell.x + step.x, cell.y + step.y};
      if (!seen.contains(next) || seen[next] != 0 || !(next == to || passable(next))) continue;
      seen[next] = 1;
      open.push_back(next);
    }
  }
  return false;
}

}  // namespace

bool boundsSeparate(const ObservedMap& map, const Vec2& robot, const Vec2& place) {
  if (map.bounds().empty() || map.empty()) return false;
  const Cell from = map.geometry().cellAt(robot), to = map.geometry().cellAt(place);
  const auto inside = [&map](Cell c) { return !isOccupied(map.grid()[c]); };
  const auto anywhere = [&](Cell c) { return inside(c) || !map.allowed(c); };
  return !connected(map.geometry(), from, to, inside) && connected(map.geometry(), from, to, anywhere);
}

}  // namespace frontier_pilot::exploration
