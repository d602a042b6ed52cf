#include "planning/inflation_exit.h"

#include <algorithm>
#include <cmath>

#include "frontier_pilot/grids/cell_search.h"

namespace frontier_pilot::planning {
namespace {

/// Extra cost per metre at zero distance from an obstacle.
constexpr double kContactWeight = 4.0;

/// Cost of steps around the robot; cells under the robot itself count as free.
class StepCost {
 public:
  StepCost(const ClearanceMap& map, Cell robot, int reach) : map_(map), robot_(robot), reach_(reach) {}

  /// [m], more near an obstacle; negative if the step is not possible. A diagonal step needs both cells beside it to be
  /// free.
  double operator()(Cell cell, Cell next) const {
    if (!isOpen(next) || !isOpen({next.x, cell.y}) || !isOpen({cell.x, next.y})) return -1.0;
    const double room = std::min(1.0, map_.field().at(next) / map_.requiredClearance());
    const double step = std::hypot(next.x - cell.x, next.y - cell.y) * map_.geometry().resolution;
    return step * (1.0 + kContactWeight * (1.0 - room));
  }

 private:
  bool isOpen(Cell cell) const {
    const int dx = cell.x - robot_.x;
    const int dy = cell.y - robot_.y;
    if (dx * dx + dy * dy > reach_ * reach_ || !map_.geometry().contains(cell)) return false;
    const bool under_the_robot = std::hypot(dx, dy) * map_.geometry().resolution < map_.params().inscribed_radius;
    return under_the_robot || !map_.isOccupied(cell);
  }

  const ClearanceMap& map_;
  Cell robot_;
  int reach_;
};

}  // namespace

std::vector<InflationExit> findInflationExits(const ClearanceMap& map, Cell from, double radius, bool beyond) {
  const int reach = static_cast<int>(std::ceil(radius / map.geometry().resolution));
  grids::ExitSearch search(from, reach);
  std::vector<InflationExit> exits;
  search.run(
      beyond, [&](Cell cell) { return map.isPassable(cell); }, StepCost(map, from, reach),
      [&](Cell cell, double cost) {
        exits.push_back({cost, search.wayTo(cell)});
      });
  return exits;
}

}  // namespace frontier_pilot::planning
