#include "navigation/obstacle_layer.h"

#include <cmath>

namespace frontier_pilot::navigation {

bool ObstacleLayer::update(const LaserScan2& scan, const ScanPoints& points, const Pose2& T_map_base,
                           planning::ClearanceMap& map, Time now) {
  bool changed = false;
  const Pose2 T_map_sensor = T_map_base * scan.T_base_sensor;
  for (auto it = seen_.begin(); it != seen_.end();) {
    const Cell cell = map.geometry().cell(it->first);
    const bool old = toSeconds(now - it->second) > params_.memory;
    if (old || isGone(scan, T_map_sensor, map.geometry().centre(cell))) {
      map.setLive(cell, false);
      it = seen_.erase(it);
      changed = true;
    } else {
      ++it;
    }
  }
  return mark(points, T_map_sensor.position(), map, now) || changed;
}

bool ObstacleLayer::mark(const ScanPoints& points, const Vec2& robot, planning::ClearanceMap& map, Time now) {
  bool changed = false;
  const GridGeometry& grid = map.geometry();
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec2 point(static_cast<double>(points.x[i]), static_cast<double>(points.y[i]));
    if ((point - robot).squaredNorm() > params_.range * params_.range) continue;
    const Cell cell = grid.cellAt(point);
    if (!map.isKnownFree(cell) || map.isMapOccupiedNear(cell, params_.map_tolerance)) continue;
    const bool fresh = seen_.insert_or_assign(grid.index(cell), now).second;
    if (fresh) map.setLive(cell, true);
    changed = changed || fresh;
  }
  return changed;
}

bool ObstacleLayer::isGone(const LaserScan2& scan, const Pose2& T_map_sensor, const Vec2& obstacle) const {
  const Vec2 seen = T_map_sensor.inverse() * obstacle;
  const double range = seen.norm();
  const double turns = std::remainder(bearing(seen) - scan.angle_min, 2.0 * kPi * (scan.angle_increment > 0 ? 1 : -1));
  const auto beams = static_cast<long>(scan.ranges.size());
  long beam = std::lround(turns / scan.angle_increment);
  if (beam < 0) beam += std::lround(2.0 * kPi / std::abs(scan.angle_increment));
  if (beam < 0 || beam >= beams) return false;
  // Its neighbours must agree: one drop-out does not make an obstacle vanish.
  for (long i = std::max(0L, beam - 1); i <= std::min(beams - 1, beam + 1); ++i) {
    const RangeReading reading = readBeam(scan, static_cast<std::size_t>(i));
    if (reading.kind == RangeKind::kInvalid || reading.distance < range + params_.seen_through) return false;
  }
  return true;
}

bool ObstacleLayer::clear(planning::ClearanceMap& map) {
  const bool any = !seen_.empty();
  for (const auto& [index, time] : seen_) map.setLive(map.geometry().cell(index), false);
  seen_.clear();
  return any;
}

}  // namespace frontier_pilot::navigation
