#include "exploration/limits/way_inside.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "frontier_pilot/core/grid_traversal.h"
#include "frontier_pilot/grids/cell_search.h"

namespace frontier_pilot::exploration {
namespace {

constexpr double kMargin = 0.5;    ///< by which the navigation's way may be longer than the shortest path [m]
constexpr double kLongest = 10.0;  ///< farther places on the path have to be in sight [m]
constexpr double kShortest = 0.6;  ///< steps along the path are not shorter, even if a corner is in the way [m]

/// Whether the line leads over known free cells within the bounds; on the explorer's map all others are not free.
bool lineIsFree(const ObservedMap& map, const Vec2& from, const Vec2& to) {
  return visitCells(map.geometry(), from, to, [&](Cell c) { return isFree(map.grid().get(c, kUnknown)); });
}

bool laneIsFree(const ObservedMap& map, const Vec2& from, const Vec2& to, double half_width) {
  const Vec2 along = to - from;
  if (along.isZero()) return true;
  const Vec2 across = Vec2(-along.y(), along.x()).normalized();
  const int lines = static_cast<int>(std::ceil(half_width / map.geometry().resolution));
  for (int i = -lines; i <= lines; ++i) {
    const Vec2 side = half_width * i / std::max(lines, 1) * across;
    if (!lineIsFree(map, from + side, to + side)) return false;
  }
  return true;
}

/// Whether a robot with this half width cannot touch anything out of bounds on a way from one place to the other of
/// this length [m]: all such ways lie in an ellipse with the two as its focal points.
bool noWayLeadsOutside(const ObservedMap& map, const Vec2& from, const Vec2& to, double length, double half_width) {
  const double sum = length + 2.0 * half_width;
  const Vec2 middle = (from + to) / 2.0;
  const Vec2 half(sum / 2.0, sum / 2.0);
  const GridGeometry& geometry = map.geometry();
  CellRect box;
  box.include(geometry.cellAt(middle - half));
  box.include(geometry.cellAt(middle + half));
  box = box.intersection(geometry.rect());
  for (int y = box.y; y < box.y + box.height; ++y) {
    for (int x = box.x; x < box.x + box.width; ++x) {
      if (map.allowed({x, y})) continue;
      const Vec2 cell = geometry.centre({x, y});
      if ((cell - from).norm() + (cell - to).norm() <= sum) return false;
    }
  }
  return true;
}

/// The cells of the shortest path, beginning at its end, which is reached.
std::vector<Cell> pathFrom(const TravelField& travel, Cell end) {
  std::vector<Cell> path{end};
  for (Cell next = nextTowardsOrigin(travel, end); next != path.back(); next = nextTowardsOrigin(travel, next)) {
    path.push_back(next);
  }
  return path;
}

/// The first place of the path up to which the navigation may choose its own way; the path's size if there is none.
/// The ellipses of nearer places lie in those of farther ones.
std::size_t freeChoice(const TravelField& travel, const ObservedMap& map, const Vec2& robot, const Vec2& goal,
                       const std::vector<Cell>& path, double half_width) {
  std::size_t outside = 0, inside = path.size();
  while (outside < inside) {
    const std::size_t i = (outside + inside) / 2;
    const Vec2 on_path = map.geometry().centre(path[i]);
    const Vec2 place = i == 0 ? goal : on_path;
    const double length = travel.distance(path[i]) + (place - on_path).norm() + kMargin;
    if (length <= kLongest && noWayLeadsOutside(map, robot, place, length, half_width)) {
      inside = i;
    } else {
      outside = i + 1;
    }
  }
  return inside;
}

}  // namespace

Vec2 stopOnTheWay(const TravelField& travel, const ObservedMap& map, const Vec2& robot, const Vec2& goal,
                  const std::optional<Cell>& end, const LaneWidth& lane) {
  constexpr double kNear = 1.0;  // [m]: a path of a robot too near to an obstacle begins at some distance from it
  if (map.bounds().empty() || !end || laneIsFree(map, robot, goal, lane.wanted)) return goal;
  const GridGeometry& geometry = map.geometry();
  const std::vector<Cell> path = pathFrom(travel, *end);
  if ((geometry.centre(path.back()) - robot).norm() > kNear) return goal;
  const std::size_t free_from = freeChoice(travel, map, robot, goal, path, lane.least);
  std::size_t step = 0;  // the end of a short step along the path
  for (const double half_width : {lane.wanted, lane.least}) {
    for (step = 0; step < path.size() && travel.distance(path[step]) > kShortest; ++step) {
      Vec2 place = step == 0 ? goal : geometry.centre(path[step]);
      if (step >= free_from || laneIsFree(map, robot, place, half_width)) return place;
    }
  }
  return step == 0 ? goal : geometry.centre(path[std::min(step, path.size() - 1)]);
}

}  // namespace frontier_pilot::exploration
