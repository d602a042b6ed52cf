#include "fleet/bay_search.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <queue>
#include <utility>

#include "fleet/path_conflict.h"
#include "frontier_pilot/grids/cell_search.h"

namespace frontier_pilot::fleet {
namespace {

/// Clearance on top of the radius [cells], as the navigator's planner wants it.
constexpr double kClearance = 1.4;

/// Dijkstra's search over the cells of a square around the robot, each of which is examined once, when it is reached.
class BaySearch {
 public:
  BaySearch(const OccupancyGrid& map, const Vec2& from, double radius)
      : map_(map),
        start_(map.geometry().cellAt(from)),
        square_(CellRect{start_.x, start_.y, 1, 1}
                    .grown(static_cast<int>(kBayReach / map.resolution()))
                    .intersection(map.geometry().rect())),
        reach_(radius / map.resolution() + kClearance),
        costs_(static_cast<std::size_t>(square_.width) * static_cast<std::size_t>(square_.height), kFar) {}

  template <class Allowed, class Wanted>
  std::optional<Vec2> run(Allowed allowed, Wanted wanted) {
    if (!square_.contains(start_)) return std::nullopt;
    push(start_, 0.0F);
    while (!queue_.empty()) {
      const auto [cost, index] = queue_.top();
      queue_.pop();
      if (cost > costs_[index]) continue;
      const Cell cell{square_.x + static_cast<int>(index) % square_.width,
                      square_.y + static_cast<int>(index) / square_.width};
      const Vec2 place = map_.geometry().centre(cell);
      const bool is_start = cell == start_;
      if (!is_start && (!fits(cell) || !allowed(place))) continue;
      if (fits(cell) && wanted(place)) return place;
      for (const Cell& step : grids::kNeighbourSteps)
        push({cell.x + step.x, cell.y + step.y}, cost + (step.x != 0 && step.y != 0 ? 1.41421F : 1.0F));
    }
    return std::nullopt;
  }

 private:
  static constexpr float kFar = 1e9F;

  void push(Cell cell, float cost) {
    if (!square_.contains(cell) || static_cast<double>(cost) * map_.resolution() > kBayReach) return;
    const auto index = static_cast<std::size_t>(cell.y - square_.y) * static_cast<std::size_t>(square_.width) +
                       static_cast<std::size_t>(cell.x - square_.x);
    if (cost >= costs_[index]) return;
    costs_[index] = cost;
    queue_.emplace(cost, index);
  }

  /// Whether the disc around the cell is known to be free.
  bool fits(Cell cell) const {
    const int most = static_cast<int>(reach_);
    for (int dy = -most; dy <= most; ++dy) {
      for (int dx = -most; dx <= most; ++dx) {
        const bool inside = dx * dx + dy * dy <= reach_ * reach_;
        if (inside && !isFree(map_.get({cell.x + dx, cell.y + dy}, kUnknown))) return false;
      }
    }
    return true;
  }

  const OccupancyGrid& map_;
  Cell start_;
  CellRect square_;
  double reach_;  ///< [cells]
  std::vector<float> costs_;
  std::priority_queue<std::pair<float, std::size_t>, std::vector<std::pair<float, std::size_t>>, std::greater<>> queue_;
};

bool isOff(const std::vector<KeepOff>& lines, const Vec2& place) {
  return std::all_of(lines.begin(), lines.end(),
                     [&](const KeepOff& off) { return distanceTo(off.line, place) >= off.apart; });
}

}  // namespace

std::optional<Vec2> findBay(const OccupancyGrid& map, const Vec2& from, double radius, const std::vector<KeepOff>& off,
                            const std::vector<KeepOff>& bodies) {
  if (map.empty()) return std::nullopt;
  return BaySearch(map, from, radius)
      .run([&](const Vec2& place) { return isOff(bodies, place); },
           [&](const Vec2& place) { return isOff(off, place); });
}

}  // namespace frontier_pilot::fleet
