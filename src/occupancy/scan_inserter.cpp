#include "frontier_pilot/occupancy/scan_inserter.h"

#include <algorithm>
#include <cmath>

#include "frontier_pilot/core/grid_traversal.h"

namespace frontier_pilot::occupancy {

Insertion ScanInserter::insert(const surfaces::SurfaceScan& scan, const Pose2& T_map_base, OccupancyMap& map) {
  readRays(scan, T_map_base, map.parameters().resolution);
  if (rays_.empty()) return Insertion::kAllInvalid;
  const MapRoom room = reserve(T_map_base, map);
  if (room != MapRoom::kEnough) return room == MapRoom::kTooFar ? Insertion::kTooFar : Insertion::kOutOfBounds;
  map.beginScan();
  markHits(map);
  clearRays(map);
  clearFootprint(T_map_base.position(), map);
  return Insertion::kInserted;
}

void ScanInserter::readRays(const surfaces::SurfaceScan& scan, const Pose2& T_map_base, double resolution) {
  const Pose2 T_map_sensor = T_map_base * scan.T_base_sensor;
  rays_.clear();
  for (std::size_t i = 0; i < scan.free.size(); ++i) {
    const Pose2 T_map_scanner = scan.free_mounts.empty() ? T_map_sensor : T_map_base * scan.free_mounts[i];
    const Vec2 unit = direction(T_map_scanner.yaw + scan.free[i]);
    const Vec2 sensor = T_map_scanner.position();
    rays_.push_back({sensor, sensor + std::min(scan.range_max, parameters_.max_clear_range) * unit, std::nullopt});
  }
  const Rotation2 R_map_base(T_map_base.yaw);
  const auto inMap = [&](const Vec2& point) { return R_map_base.applied(point, T_map_base.position()); };
  for (std::size_t i = 0; i < scan.points.size(); ++i) {
    const surfaces::SurfacePoint& point = scan.points[i];
    const Vec2 sensor = scan.point_origins.empty() ? T_map_sensor.position() : inMap(scan.point_origins[i]);
    rays_.push_back(rayThatMet(inMap(point.position), R_map_base * point.normal, sensor, resolution));
  }
  shortenLone(scan);
}

ScanInserter::Ray ScanInserter::rayThatMet(const Vec2& point, const Vec2& normal, const Vec2& sensor,
                                           double resolution) const {
  constexpr double kFlattest = 0.1;  // cosine: at flatter angles the margin would leave too much uncleared
  const double range = (point - sensor).norm();
  // `normalized` returns a zero vector unchanged.
  const Vec2 unit = (point - sensor).normalized();
  const Vec2 behind = normal.isZero(0.0) ? unit : Vec2(-normal);
  const double margin = parameters_.clear_margin * resolution / std::max(kFlattest, unit.dot(behind));
  return {sensor, sensor + std::max(0.0, range - margin) * unit, point + parameters_.hit_offset * resolution * behind};
}

void ScanInserter::shortenLone(const surfaces::SurfaceScan& scan) {
  const std::size_t first = rays_.size() - scan.points.size();
  const auto reachOf = [&](const Ray& ray) { return (ray.clear_to - ray.from).norm(); };
  for (const std::size_t lone : scan.lone) {
    Ray& ray = rays_[first + lone];
    const double reach = std::min(reachOf(rays_[first + lone - 1]), reachOf(rays_[first + lone + 1]));
    const Vec2 gap = ray.from + std::min(reach, reachOf(ray)) * (ray.clear_to - ray.from).normalized();
    const Passage passage{gap, ray.from};
    if (!isSlit(passage)) ray.clear_to = gap;
    ray.hit.reset();
    constexpr std::size_t kMost = 500;
    passages_.push_back(passage);
    if (passages_.size() > kMost) passages_.pop_front();
  }
}

bool ScanInserter::isSlit(const Passage& passage) const {
  constexpr double kSame = 0.3;       // [m]
  constexpr double kElsewhere = 0.1;  // [m]
  return std::any_of(passages_.begin(), passages_.end(), [&](const Passage& other) {
    return (other.at - passage.at).norm() < kSame && (other.from - passage.from).norm() > kElsewhere;
  });
}

MapRoom ScanInserter::reserve(const Pose2& T_map_base, OccupancyMap& map) const {
  const Vec2 radius = Vec2::Constant(parameters_.robot_radius);
  Vec2 low = T_map_base.position() - radius;
  Vec2 high = T_map_base.position() + radius;
  for (const Ray& ray : rays_) {
    const Vec2 hit = ray.hit.value_or(ray.clear_to);
    low = low.cwiseMin(ray.from).cwiseMin(ray.clear_to).cwiseMin(hit);
    high = high.cwiseMax(ray.from).cwiseMax(ray.clear_to).cwiseMax(hit);
  }
  return map.reserve(low, high);
}

void ScanInserter::markHits(OccupancyMap& map) const {
  for (const Ray& ray : rays_) {
    if (ray.hit) map.hit(map.geometry().cellAt(*ray.hit));
  }
}

void ScanInserter::clearRays(OccupancyMap& map) const {
  const GridGeometry geometry = map.geometry();
  for (const Ray& ray : rays_) {
    visitCells(geometry, ray.from, ray.clear_to, [&](Cell cell) {
      // A beam that a surface did not reflect looks like one that met nothing. It therefore ends at the first obstacle
      // on its way, whose cell it makes less likely; only when enough such beams have cleared that cell do others pass.
      const bool conflicting = !ray.hit && map.isOccupied(cell);
      map.miss(cell);
      return !conflicting;
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

}  // namespace frontier_pilot::occupancy
