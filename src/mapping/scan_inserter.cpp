#include "frontier_pilot/mapping/scan_inserter.h"

#include <algorithm>
#include <cmath>

#include "frontier_pilot/core/ray_casting.h"

namespace frontier_pilot {

Insertion ScanInserter::insert(const LaserScan2& scan, const Pose2& T_map_base, OccupancyMap& map) {
  const Pose2 T_map_sensor = T_map_base * scan.T_base_sensor;
  const Vec2 sensor = T_map_sensor.position();
  readRays(scan, T_map_sensor, map.parameters().resolution);
  if (rays_.empty()) return Insertion::kAllInvalid;
  if (!reserve(T_map_base, sensor, map)) return Insertion::kOutOfBounds;
  map.beginScan();
  markHits(map);
  clearRays(sensor, map);
  clearFootprint(T_map_base.position(), map);
  return Insertion::kInserted;
}

void ScanInserter::readRays(const LaserScan2& scan, const Pose2& T_map_sensor, double resolution) {
  rays_.clear();
  for (std::size_t beam = 0; beam < scan.ranges.size(); ++beam) {
    if (const auto read = ray(scan, beam, T_map_sensor, resolution)) rays_.push_back(*read);
  }
}

std::optional<ScanInserter::Ray> ScanInserter::ray(const LaserScan2& scan, std::size_t beam, const Pose2& T_map_sensor,
                                                   double resolution) const {
  const RangeReading reading = readBeam(scan, beam);
  // Too near says that something is there, but not where.
  if (reading.kind == RangeKind::kInvalid || reading.kind == RangeKind::kTooNear) return std::nullopt;
  const Vec2 sensor = T_map_sensor.position();
  const Vec2 unit = direction(T_map_sensor.yaw + scan.angle(beam));
  if (reading.kind == RangeKind::kFree) {
    return Ray{sensor + std::min(reading.distance, parameters_.max_clear_range) * unit, std::nullopt};
  }
  const double clear = std::max(0.0, reading.distance - parameters_.clear_margin * resolution);
  return Ray{sensor + clear * unit, sensor + (reading.distance + parameters_.hit_offset * resolution) * unit};
}

bool ScanInserter::reserve(const Pose2& T_map_base, const Vec2& sensor, OccupancyMap& map) const {
  const Vec2 radius = Vec2::Constant(parameters_.robot_radius);
  Vec2 low = sensor.cwiseMin(T_map_base.position() - radius);
  Vec2 high = sensor.cwiseMax(T_map_base.position() + radius);
  for (const Ray& ray : rays_) {
    const Vec2& end = ray.hit ? *ray.hit : ray.clear_to;
    low = low.cwiseMin(end);
    high = high.cwiseMax(end);
  }
  return map.reserve(low, high);
}

void ScanInserter::markHits(OccupancyMap& map) const {
  for (const Ray& ray : rays_) {
    if (ray.hit) map.hit(map.geometry().cellAt(*ray.hit));
  }
}

void ScanInserter::clearRays(const Vec2& sensor, OccupancyMap& map) const {
  const GridGeometry geometry = map.geometry();
  for (const Ray& ray : rays_) {
    visitCells(geometry, sensor, ray.clear_to, [&](Cell cell) {
      // A beam that was lost at a wall looks like a free one. So it argues with the first obstacle on its way, and does
      // not look behind until enough others have agreed.
      const bool doubtful = !ray.hit && map.isOccupied(cell);
      map.miss(cell);
      return !doubtful;
    });
  }
}

void ScanInserter::clearFootprint(const Vec2& robot, OccupancyMap& map) const {
  const GridGeometry& geometry = map.geometry();
  const Cell low = geometry.cellAt(robot - Vec2::Constant(parameters_.robot_radius));
  const Cell high = geometry.cellAt(robot + Vec2::Constant(parameters_.robot_radius));
  for (int y = low.y; y <= high.y; ++y) {
    for (int x = low.x; x <= high.x; ++x) {
      if ((geometry.centre({x, y}) - robot).norm() <= parameters_.robot_radius) map.miss({x, y});
    }
  }
}

}  // namespace frontier_pilot
