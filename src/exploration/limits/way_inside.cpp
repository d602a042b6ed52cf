#include "exploration/limits/way_inside.h"

#include <vector>

#include "frontier_pilot/core/grid_traversal.h"

namespace frontier_pilot::exploration {
namespace {

constexpr double kShortest = 0.6;  ///< steps along the path are not shorter, even if a corner is in the way [m]

bool lineIsAllowed(const ObservedMap& map, const Vec2& from, const Vec2& to) {
  return visitCells(map.geometry(), from, to, [&](Cell c) { return map.allowed(c); });
}

bool laneIsAllowed(const ObservedMap& map, const Vec2& from, const Vec2& to, double half_width) {
  const Vec2 along = to - from;
  if (along.isZero()) return true;
  const Vec2 side = half_width * Vec2(-along.y(), along.x()).normalized();
  return lineIsAllowed(map, from, to) && lineIsAllowed(map, from + side, to + side) &&
         lineIsAllowed(map, from - side, to - side);
}

/// The neighbour nearest to where the paths begin; `cell` itself if none is nearer.
Cell stepBack(const TravelField& travel, Cell cell) {
  Cell best = cell;
  for (int dy = -1; dy <= 1; ++dy) {
    for (int dx = -1; dx <= 1; ++dx) {
      const Cell next{cell.x + dx, cell.y + dy};
      if (travel.distance(next) < travel.distance(best)) best = next;
    }
  }
  return best;
}

/// The cells of the shortest path, beginning at the goal.
std::vector<Cell> pathFrom(const TravelField& travel, Cell goal) {
  std::vector<Cell> path;
  if (!travel.reached(goal)) return path;
  path.push_back(goal);
  for (Cell next = stepBack(travel, goal); next != path.back(); next = stepBack(travel, next)) path.push_back(next);
  return path;
}

}  // namespace

Vec2 stopOnTheWay(const TravelField& travel, const ObservedMap& map, const Vec2& robot, const Vec2& goal,
                  double half_width) {
  constexpr double kNear = 1.0;  // [m]: a path of a robot too near to an obstacle begins at some distance from it
  if (map.bounds().empty() || map.empty() || laneIsAllowed(map, robot, goal, half_width)) return goal;
  const GridGeometry& geometry = map.geometry();
  const std::vector<Cell> path = pathFrom(travel, geometry.cellAt(goal));
  if (path.empty() || (geometry.centre(path.back()) - robot).norm() > kNear) return goal;
  for (const Cell cell : path) {
    const Vec2 place = geometry.centre(cell);
    if (travel.distance(cell) <= kShortest || laneIsAllowed(map, robot, place, half_width)) return place;
  }
  return goal;
}

}  // namespace frontier_pilot::exploration
