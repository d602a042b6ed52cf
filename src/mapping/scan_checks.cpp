#include "mapping/scan_checks.h"

#include <cmath>

#include "frontier_pilot/core/bounds.h"

namespace frontier_pilot::mapping {

bool isWellFormed(const LaserScan2& scan) {
  const bool finite = std::isfinite(scan.angle_min) && std::isfinite(scan.angle_increment) &&
                      std::isfinite(scan.range_min) && std::isfinite(scan.range_max) && scan.T_base_sensor.isFinite();
  const bool mounts = !scan.isMoving() || scan.moving_mounts.size() == scan.ranges.size();
  return finite && mounts && scan.angle_increment != 0.0 && scan.range_min >= 0.0 && scan.range_max > scan.range_min &&
         scan.range_max <= bounds::kUsedRange && !scan.ranges.empty() &&
         bounds::isWithin(scan.T_base_sensor.position().norm(), bounds::kMostMount);
}

bool isUsable(const Pose2& T_odom_base) {
  return T_odom_base.isFinite() &&
         bounds::isWithin(T_odom_base.position().cwiseAbs().maxCoeff(), bounds::kMostCoordinate);
}

bool wasCorrected(ScanVerdict verdict) {
  return verdict == ScanVerdict::kMisfit || verdict == ScanVerdict::kNotLocated || !isDropped(verdict);
}

ScanVerdict verdictOf(occupancy::Insertion insertion) {
  switch (insertion) {
    case occupancy::Insertion::kInserted:
      return ScanVerdict::kInserted;
    case occupancy::Insertion::kAllInvalid:
      return ScanVerdict::kAllInvalid;
    case occupancy::Insertion::kTooFar:
      return ScanVerdict::kTooFar;
    case occupancy::Insertion::kOutOfBounds:
      break;
  }
  return ScanVerdict::kOutOfBounds;
}

}  // namespace frontier_pilot::mapping
