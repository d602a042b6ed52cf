#include "mapping/scan_checks.h"

#include <cmath>

#include "frontier_pilot/core/bounds.h"
#include "frontier_pilot/grids/ray_casting.h"

namespace frontier_pilot::mapping {

bool isWellFormed(const LaserScan2& scan) {
  const bool finite = std::isfinite(scan.angle_min) && std::isfinite(scan.angle_increment) &&
                      std::isfinite(scan.range_min) && std::isfinite(scan.range_max) && scan.T_base_sensor.isFinite();
  const bool mounts = !scan.isMoving() || scan.moving_mounts.size() == scan.ranges.size();
  return finite && mounts && scan.angle_increment != 0.0 && scan.range_min >= 0.0 && scan.range_max > scan.range_min &&
         scan.range_max <= bounds::kUsedRange && !scan.ranges.empty() &&
         bounds::isWithin(scan.T_base_sensor.position().norm(), bounds::kMostMount);
}

bool isBlind(const LaserScan2& scan, const Pose2& T_map_base, const occupancy::OccupancyMap& map) {
  const CellRect inside = map.geometry().rect();
  const auto is_wall = [&](Cell cell) { return inside.contains(cell) && map.isOccupied(cell); };
  return !map.isBlank() && grids::missesWalls(scan, T_map_base, map.geometry(), is_wall);
}

bool isUsable(const Pose2& T_odom_base) {
  return T_odom_base.isFinite() &&
         bounds::isWithin(T_odom_base.position().cwiseAbs().maxCoeff(), bounds::kMostCoordinate);
}

ScanVerdict verdictOf(occupancy::Insertion insertion) {
  switch (insertion) {
    case occupancy::Insertion::kInserted:
      return ScanVerdict::kInserted;
    case occupancy::Insertion::kAllInvalid:
      return ScanVerdict::kAllInvalid;
    case occupancy::Insertion::kOutOfBounds:
      break;
  }
  return ScanVerdict::kOutOfBounds;
}

}  // namespace frontier_pilot::mapping
