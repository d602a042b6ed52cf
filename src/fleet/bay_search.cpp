#include "fleet/bay_search.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <queue>
#include <utility>

#include "fleet/path_conflict.h"
#include "frontier_pilot/grids/cell_search.h"

namespace frontier_pilot::fleet {
namespace {

/// Clearance on top of the radius [cells], as the navigator's planner wants it.
constexpr double kClearance = 1.4;

/// Dijkstra's search over a lattice of cells in a square around the robot, each of which is examined once, when it is
/// reached.
class BaySearch {
 public:
  BaySearch(const OccupancyGrid& map, const Vec2& from, double radius)
      : map_(map),
        start_(map.geometry().cellAt(from)),
        step_(std::max(1, static_cast<int>(std::ceil(kBaySpacing / map.resolution() - 1e-6)))),
        square_(CellRect{0, 0, 1, 1}.grown(static_cast<int>(kBayReach / (step_ * map.resolution())))),
        reach_(radius / map.resolution() + kClearance),
        costs_(static_cast<std::size_t>(square_.width) * static_cast<std::size_t>(square_.height), kFar) {}

  template <class Allowed, class Wanted>
  std::optional<Vec2> run(Allowed allowed, Wanted wanted) {
    push({0, 0}, 0.0F);
    for (std::size_t examined = 0; !queue_.empty() && examined < kMostBayPlaces;) {
      const auto [cost, index] = queue_.top();
      queue_.pop();
      if (cost > costs_[index]) continue;
      ++examined;
      const Cell node{square_.x + static_cast<int>(index) % square_.width,
                      square_.y + static_cast<int>(index) / square_.width};
      const Cell cell = cellOf(node);
      const Vec2 place = map_.geometry().centre(cell);
      const bool is_free = fits(cell);
      if (cell != start_ && !(is_free && allowed(place))) continue;
      if (is_free && wanted(place)) return place;
      for (const Cell& step : grids::kNeighbourSteps)
        push({node.x + step.x, node.y + step.y}, cost + (step.x != 0 && step.y != 0 ? 1.41421F : 1.0F));
    }
    return std::nullopt;
  }

 private:
  static constexpr float kFar = 1e9F;

  Cell cellOf(Cell node) const { return {start_.x + step_ * node.x, start_.y + step_ * node.y}; }

  void push(Cell node, float cost) {
    const bool inside = square_.contains(node) && map_.geometry().rect().contains(cellOf(node));
    if (!inside || static_cast<double>(cost) * step_ * map_.resolution() > kBayReach) return;
    const auto index = static_cast<std::size_t>(node.y - square_.y) * static_cast<std::size_t>(square_.width) +
                       static_cast<std::size_t>(node.x - square_.x);
    if (cost >= costs_[index]) return;
    costs_[index] = cost;
    queue_.emplace(cost, index);
  }

  /// Whether the disc around the cell is known to be free.
  bool fits(Cell cell) const {
    const int most = static_cast<int>(reach_);
    const CellRect box = CellRect{cell.x, cell.y, 1, 1}.grown(most);
    if (!(box.intersection(map_.geometry().rect()) == box)) return false;
    for (int dy = -most; dy <= most; ++dy) {
      const int half = static_cast<int>(std::sqrt(reach_ * reach_ - dy * dy));
      const std::int8_t* middle = map_.row(cell.y + dy) + cell.x;
      if (!std::all_of(middle - half, middle + half + 1, isFree)) return false;
    }
    return true;
  }

  const OccupancyGrid& map_;
  Cell start_;
  int step_;         ///< from a node of the lattice to the next [cells]
  CellRect square_;  ///< its nodes, counted from the start
  double reach_;     ///< [cells]
  std::vector<float> costs_;
  std::priority_queue<std::pair<float, std::size_t>, std::vector<std::pair<float, std::size_t>>, std::greater<>> queue_;
};

std::vector<KeepOff> nearest(std::vector<KeepOff> lines, const Vec2& place) {
  if (lines.size() <= kMostBayLines) return lines;
  std::vector<std::pair<double, std::size_t>> order;
  for (const KeepOff& off : lines) order.emplace_back(distanceTo(off.line, place), order.size());
  std::sort(order.begin(), order.end());
  std::vector<KeepOff> result;
  for (std::size_t i = 0; i < kMostBayLines; ++i) result.push_back(std::move(lines[order[i].second]));
  return result;
}

/// Whether `distanceTo` would be less than `apart`, without roots and lengths: it is asked at every place.
bool comesNear(const KeepOff& off, const Vec2& place) {
  const double most = off.apart > 0.0 ? square(off.apart) : 0.0;
  if ((off.line.front() - place).squaredNorm() < most) return true;
  for (std::size_t i = 0; i + 1 < off.line.size(); ++i) {
    const Vec2 step = off.line[i + 1] - off.line[i];
    const Vec2 to_place = place - off.line[i];
    const double part = std::clamp(step.dot(to_place) / std::max(step.squaredNorm(), 1e-12), 0.0, 1.0);
    if ((part * step - to_place).squaredNorm() < most) return true;
  }
  return false;
}

bool isOff(const std::vector<KeepOff>& lines, const Vec2& place) {
  return std::none_of(lines.begin(), lines.end(), [&](const KeepOff& off) { return comesNear(off, place); });
}

}  // namespace

std::optional<Vec2> findBay(const OccupancyGrid& map, const Vec2& from, double radius, const std::vector<KeepOff>& off,
                            const std::vector<KeepOff>& bodies) {
  if (map.empty()) return std::nullopt;
  const std::vector<KeepOff> near = nearest(off, from);
  return BaySearch(map, from, radius)
      .run([&](const Vec2& place) { return isOff(bodies, place); },
           [&](const Vec2& place) { return isOff(near, place); });
}

}  // namespace frontier_pilot::fleet
