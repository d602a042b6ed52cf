#include "planning/inflation_exit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <tuple>

#include "frontier_pilot/grids/cell_window.h"

namespace frontier_pilot::planning {
namespace {

/// What it costs to be in contact, in metres a metre.
constexpr double kContactWeight = 4.0;

/// Dijkstra's search over a small window around the robot.
class InflationExitSearch {
 public:
  InflationExitSearch(const ClearanceMap& map, Cell from, double radius, bool beyond)
      : map_(map),
        beyond_(beyond),
        from_(from),
        reach_(static_cast<int>(std::ceil(radius / map.geometry().resolution))),
        cost_(from, reach_, std::numeric_limits<double>::infinity()),
        parent_(from, reach_, from) {}

  std::vector<InflationExit> run() {
    push(from_, from_, 0.0);
    while (!queue_.empty()) {
      const auto [cost, y, x] = queue_.top();
      const Cell cell{x, y};
      queue_.pop();
      if (cost > cost_[cell]) continue;
      const bool out = map_.isPassable(cell);
      if (out) escapes_.push_back({cost, wayTo(cell)});
      if (!out || beyond_) expand(cell, cost);
    }
    return std::move(escapes_);
  }

 private:
  bool isOpen(Cell cell) const {
    const int dx = cell.x - from_.x;
    const int dy = cell.y - from_.y;
    if (dx * dx + dy * dy > reach_ * reach_ || !map_.geometry().contains(cell)) return false;
    const bool under_the_robot = std::hypot(dx, dy) * map_.geometry().resolution < map_.params().inscribed_radius;
    return under_the_robot || !map_.isOccupied(cell);
  }

  void push(Cell cell, Cell parent, double cost) {
    if (cost >= cost_[cell]) return;
    cost_[cell] = cost;
    parent_[cell] = parent;
    queue_.emplace(cost, cell.y, cell.x);
  }

  void expand(Cell cell, double cost) {
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) {
        const Cell next{cell.x + dx, cell.y + dy};
        if ((dx == 0 && dy == 0) || !isOpen(next)) continue;
        if (!isOpen({next.x, cell.y}) || !isOpen({cell.x, next.y})) continue;
        const double room = std::min(1.0, map_.field().at(next) / map_.requiredClearance());
        const double step = std::hypot(dx, dy) * map_.geometry().resolution;
        push(next, cell, cost + step * (1.0 + kContactWeight * (1.0 - room)));
      }
    }
  }

  std::vector<Cell> wayTo(Cell cell) const {
    std::vector<Cell> way{cell};
    while (way.back() != from_) way.push_back(parent_[way.back()]);
    std::reverse(way.begin(), way.end());
    return way;
  }

  const ClearanceMap& map_;
  bool beyond_;
  Cell from_;
  int reach_;
  grids::CellWindow<double> cost_;
  grids::CellWindow<Cell> parent_;
  std::priority_queue<std::tuple<double, int, int>, std::vector<std::tuple<double, int, int>>, std::greater<>> queue_;
  std::vector<InflationExit> escapes_;
};

}  // namespace

std::vector<InflationExit> findInflationExits(const ClearanceMap& map, Cell from, double radius, bool beyond) {
  return InflationExitSearch(map, from, radius, beyond).run();
}

}  // namespace frontier_pilot::planning
