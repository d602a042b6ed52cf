#include "any_angle_reference.h"

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <numeric>
#include <queue>
#include <utility>

#include "planning/path_smoothing.h"

namespace frontier_pilot::bench {
namespace {

constexpr int kReach = 3;
constexpr double kWorstDetour = 1.014;

std::vector<Cell> directions() {
  std::vector<Cell> all;
  for (int dy = -kReach; dy <= kReach; ++dy) {
    for (int dx = -kReach; dx <= kReach; ++dx) {
      if (std::gcd(std::abs(dx), std::abs(dy)) == 1) all.push_back({dx, dy});
    }
  }
  return all;
}

/// The centres of the cells of a shortest path along 32 directions; empty if there is none.
std::vector<Vec2> search(const planning::ClearanceMap& map, Cell start, Cell goal) {
  const GridGeometry& grid = map.geometry();
  const std::vector<Cell> steps = directions();
  std::vector<double> cost(grid.size(), std::numeric_limits<double>::infinity());
  std::vector<std::uint32_t> parent(grid.size(), 0);
  using Entry = std::pair<double, std::uint32_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  const Vec2 target = grid.centre(goal);
  const auto push = [&](Cell cell, std::size_t from, double g) {
    const std::size_t index = grid.index(cell);
    if (g >= cost[index] - 1e-12) return;
    cost[index] = g;
    parent[index] = static_cast<std::uint32_t>(from);
    queue.emplace(g + (grid.centre(cell) - target).norm(), static_cast<std::uint32_t>(index));
  };
  push(start, grid.index(start), 0.0);
  while (!queue.empty() && grid.cell(queue.top().second) != goal) {
    const auto [f, index] = queue.top();
    queue.pop();
    const Cell cell = grid.cell(index);
    const Vec2 here = grid.centre(cell);
    if (f > cost[index] + (here - target).norm() + 1e-9) continue;
    for (const Cell step : steps) {
      const Cell next{cell.x + step.x, cell.y + step.y};
      if (!map.isPassable(next)) continue;
      const Vec2 there = grid.centre(next);
      if (map.isValid(here, there)) push(next, index, cost[index] + (there - here).norm());
    }
  }
  std::vector<Vec2> points;
  if (queue.empty()) return points;
  for (std::size_t i = grid.index(goal);; i = parent[i]) {
    points.push_back(grid.centre(grid.cell(i)));
    if (i == parent[i]) break;
  }
  std::reverse(points.begin(), points.end());
  return points;
}

}  // namespace

AnyAngleReference shortestAnyAngle(const planning::ClearanceMap& map, const Vec2& start, const Vec2& goal) {
  const std::vector<Vec2> cells = search(map, map.geometry().cellAt(start), map.geometry().cellAt(goal));
  if (cells.empty()) return {};
  AnyAngleReference reference{planning::Path(cells), 0.0};
  reference.lower_bound = reference.path.length() / kWorstDetour;
  for (double gain = 1.0; gain > 1e-4;) {
    const double before = reference.path.length();
    reference.path = planning::pullString(map, reference.path.sampled(0.5 * map.geometry().resolution));
    gain = before - reference.path.length();
  }
  return reference;
}

}  // namespace frontier_pilot::bench
