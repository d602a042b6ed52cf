#include "exploration/limits/way_inside.h"

#include <vector>

#include "frontier_pilot/core/grid_traversal.h"

namespace frontier_pilot::exploration {
namespace {

constexpr double kMargin = 0.5;    ///< around a path, within which a navigation that takes another one stays [m]
constexpr double kShortest = 0.6;  ///< steps along the path are not shorter, even if a corner is in the way [m]

/// Whether the line leads over known free cells within the bounds; on the explorer's map all others are not free.
bool lineIsFree(const ObservedMap& map, const Vec2& from, const Vec2& to) {
  return visitCells(map.geometry(), from, to, [&](Cell c) { return isFree(map.grid().get(c, kUnknown)); });
}

bool laneIsFree(const ObservedMap& map, const Vec2& from, const Vec2& to, double half_width) {
  const Vec2 along = to - from;
  if (along.isZero()) return true;
  const Vec2 side = half_width * Vec2(-along.y(), along.x()).normalized();
  return lineIsFree(map, from, to) && lineIsFree(map, from + side, to + side) &&
         lineIsFree(map, from - side, to - side);
}

bool rowIsAllowed(const ObservedMap& map, int y, int begin, int end) {
  for (int x = begin; x < end; ++x) {
    if (!map.allowed({x, y})) return false;
  }
  return true;
}

/// Whether all cells of `now` are allowed that do not lie in `before`, a block inside of it.
bool growthIsAllowed(const ObservedMap& map, const CellRect& before, const CellRect& now) {
  for (int y = now.y; y < now.y + now.height; ++y) {
    const bool old = !before.empty() && y >= before.y && y < before.y + before.height;
    const int left = old ? before.x : now.x + now.width;
    const int right = old ? before.x + before.width : now.x + now.width;
    if (!rowIsAllowed(map, y, now.x, left) || !rowIsAllowed(map, y, right, now.x + now.width)) return false;
  }
  return true;
}

/// How many cells at the path's end, where the robot is, lie together in a block without anything out of bounds: there
/// the navigation may choose its own way.
std::size_t freeChoice(const ObservedMap& map, const std::vector<Cell>& path) {
  const int margin = static_cast<int>(kMargin / map.geometry().resolution);
  CellRect block;
  for (std::size_t k = 0; k < path.size(); ++k) {
    const Cell cell = path[path.size() - 1 - k];
    CellRect grown = block;
    grown.include(CellRect{cell.x, cell.y, 1, 1}.grown(margin).intersection(map.geometry().rect()));
    if (!(grown == block) && !growthIsAllowed(map, block, grown)) return k;
    block = grown;
  }
  return path.size();
}

/// The cells of the shortest path, beginning at the goal.
std::vector<Cell> pathFrom(const TravelField& travel, Cell goal) {
  std::vector<Cell> path;
  if (!travel.reached(goal)) return path;
  path.push_back(goal);
  for (Cell next = nextTowardsOrigin(travel, goal); next != path.back(); next = nextTowardsOrigin(travel, next)) {
    path.push_back(next);
  }
  return path;
}

}  // namespace

Vec2 stopOnTheWay(const TravelField& travel, const ObservedMap& map, const Vec2& robot, const Vec2& goal,
                  double half_width) {
  constexpr double kNear = 1.0;  // [m]: a path of a robot too near to an obstacle begins at some distance from it
  if (map.bounds().empty() || map.empty() || laneIsFree(map, robot, goal, half_width)) return goal;
  const GridGeometry& geometry = map.geometry();
  const std::vector<Cell> path = pathFrom(travel, geometry.cellAt(goal));
  if (path.empty() || (geometry.centre(path.back()) - robot).norm() > kNear) return goal;
  const std::size_t free_from = path.size() - freeChoice(map, path);
  if (free_from == 0) return goal;
  for (std::size_t i = 0; i < path.size(); ++i) {
    const Vec2 place = geometry.centre(path[i]);
    const bool near = travel.distance(path[i]) <= kShortest;
    if (near || i >= free_from || laneIsFree(map, robot, place, half_width)) return i == 0 ? goal : place;
  }
  return goal;
}

}  // namespace frontier_pilot::exploration
