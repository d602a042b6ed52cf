#include "navigation/obstacle_layer.h"

#include <algorithm>

namespace frontier_pilot::navigation {

template <class Goes>
bool ObstacleLayer::removeIf(planning::ClearanceMap& map, const Goes& goes) {
  const std::size_t before = seen_.size();
  for (auto it = seen_.begin(); it != seen_.end();) {
    const Cell cell = map.geometry().cell(it->first);
    if (!goes(*it, map.geometry().centre(cell))) {
      ++it;
      continue;
    }
    map.setLive(cell, false);
    kept_.erase(it->first);
    it = seen_.erase(it);
  }
  return seen_.size() < before;
}

bool ObstacleLayer::update(const ScanView& view, const ScanPoints& points, planning::ClearanceMap& map, Time now) {
  const bool removed = removeIf(map, [&](const Mark& mark, const Vec2& place) {
    const bool old = toSeconds(now - mark.second) > params_.memory && kept_.count(mark.first) == 0;
    return old || isMakingWay(place) || view.seesThrough(place, params_.seen_through);
  });
  return mark(points, view.scanner(), map, now) || removed;
}

bool ObstacleLayer::mark(const ScanPoints& points, const Vec2& robot, planning::ClearanceMap& map, Time now) {
  bool changed = false;
  const GridGeometry& grid = map.geometry();
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec2 point(static_cast<double>(points.x[i]), static_cast<double>(points.y[i]));
    if ((point - robot).squaredNorm() > params_.range * params_.range) continue;
    if (isMakingWay(point)) continue;
    const Cell cell = grid.cellAt(point);
    if (!map.isFreeFloor(cell, params_.map_tolerance)) continue;
    const bool fresh = seen_.insert_or_assign(grid.index(cell), now).second;
    if (fresh) map.setLive(cell, true);
    changed = changed || fresh;
  }
  return changed;
}

void ObstacleLayer::keepNear(const std::vector<Vec2>& places, double radius, const GridGeometry& grid) {
  constexpr std::size_t kMost = 10'000;
  for (const auto& [index, time] : seen_) {
    if (kept_.size() >= kMost) return;
    const Vec2 mark = grid.centre(grid.cell(index));
    const auto is_near = [&](const Vec2& place) { return (place - mark).squaredNorm() < radius * radius; };
    if (std::any_of(places.begin(), places.end(), is_near)) kept_.insert(index);
  }
}

bool ObstacleLayer::isMakingWay(const Vec2& point) const {
  return std::any_of(making_way_.begin(), making_way_.end(),
                     [&](const Disc& disc) { return (point - disc.centre).norm() < disc.radius; });
}

bool ObstacleLayer::clearInView(const ScanView& view, planning::ClearanceMap& map) {
  return removeIf(map, [&](const Mark&, const Vec2& place) { return view.looksAt(place); });
}

bool ObstacleLayer::clear(planning::ClearanceMap& map) {
  const bool any = !seen_.empty();
  for (const auto& [index, time] : seen_) map.setLive(map.geometry().cell(index), false);
  forget();
  return any;
}

}  // namespace frontier_pilot::navigation
