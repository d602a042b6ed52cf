#include "navigation/obstacle_layer.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>
#include <utility>

namespace frontier_pilot::navigation {
namespace {

/// The beam whose angle is nearest to the bearing of `seen` in the scanner's frame; it may lie outside of the scan.
long beamTowards(const LaserScan2& scan, const Vec2& seen) {
  const double turns = std::remainder(bearing(seen) - scan.angle_min, 2.0 * kPi * (scan.angle_increment > 0 ? 1 : -1));
  const long beam = std::lround(turns / scan.angle_increment);
  return beam < 0 ? beam + std::lround(2.0 * kPi / std::abs(scan.angle_increment)) : beam;
}

/// Where `obstacle` was in the frame of a scanner that moved, when a beam pointed at it, and that beam; nothing if none
/// did. Where the scanner was depends on the beam, and the beam on where it was: a few rounds find both, because a
/// robot turns much more slowly than its scanner.
std::optional<std::pair<long, Vec2>> seenWhileMoving(const LaserScan2& scan, const Pose2& T_map_base,
                                                     const Vec2& obstacle) {
  constexpr int kRounds = 4;
  const Vec2 in_base = T_map_base.inverse() * obstacle;
  const auto beams = static_cast<long>(scan.ranges.size());
  long beam = beamTowards(scan, scan.T_base_sensor.inverse() * in_base);
  for (int round = 0; round < kRounds; ++round) {
    const Vec2 seen = scan.mount(static_cast<std::size_t>(std::clamp(beam, 0L, beams - 1))).inverse() * in_base;
    const long next = beamTowards(scan, seen);
    if (std::abs(next - beam) <= 1 && next < beams) return std::pair(next, seen);
    beam = next;
  }
  return std::nullopt;
}

}  // namespace

bool ObstacleLayer::update(const LaserScan2& scan, const ScanPoints& points, const Pose2& T_map_base,
                           planning::ClearanceMap& map, Time now) {
  bool changed = false;
  const Pose2 T_map_sensor = T_map_base * scan.T_base_sensor;
  for (auto it = seen_.begin(); it != seen_.end();) {
    const Cell cell = map.geometry().cell(it->first);
    const bool old = toSeconds(now - it->second) > params_.memory && kept_.count(it->first) == 0;
    if (old || isMakingWay(map.geometry().centre(cell)) ||
        isGone(scan, T_map_base, T_map_sensor, map.geometry().centre(cell))) {
      map.setLive(cell, false);
      kept_.erase(it->first);
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
    if (isMakingWay(point)) continue;
    const Cell cell = grid.cellAt(point);
    if (!map.isFreeFloor(cell, params_.map_tolerance)) continue;
    const bool fresh = seen_.insert_or_assign(grid.index(cell), now).second;
    if (fresh) map.setLive(cell, true);
    changed = changed || fresh;
  }
  return changed;
}

bool ObstacleLayer::isGone(const LaserScan2& scan, const Pose2& T_map_base, const Pose2& T_map_sensor,
                           const Vec2& obstacle) const {
  Vec2 seen = T_map_sensor.inverse() * obstacle;
  long beam = beamTowards(scan, seen);
  if (scan.isMoving()) {
    const auto found = seenWhileMoving(scan, T_map_base, obstacle);
    if (!found) return false;
    std::tie(beam, seen) = *found;
  }
  const double range = seen.norm();
  const auto beams = static_cast<long>(scan.ranges.size());
  if (beam < 0 || beam >= beams) return false;
  // Its neighbours must agree: one drop-out does not make an obstacle vanish.
  for (long i = std::max(0L, beam - 1); i <= std::min(beams - 1, beam + 1); ++i) {
    const RangeReading reading = readBeam(scan, static_cast<std::size_t>(i));
    if (reading.kind == RangeKind::kInvalid || reading.distance < range + params_.seen_through) return false;
  }
  return true;
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

bool ObstacleLayer::clear(planning::ClearanceMap& map) {
  const bool any = !seen_.empty();
  for (const auto& [index, time] : seen_) map.setLive(map.geometry().cell(index), false);
  forget();
  return any;
}

}  // namespace frontier_pilot::navigation
