#include "frontier_pilot/core/laser_scan.h"

#include <cmath>
#include <cstddef>

namespace frontier_pilot {

RangeReading readRange(float range, double range_min, double range_max) {
  const double r = static_cast<double>(range);
  if (std::isnan(r) || r == 0.0) return {};
  if (std::isinf(r))
    return r < 0.0 ? RangeReading{RangeKind::kTooNear, range_min} : RangeReading{RangeKind::kFree, range_max};
  if (r < 0.0) return {};
  if (r < range_min) return {RangeKind::kTooNear, range_min};
  // Some drivers report a beam without a return as `range_max` itself.
  if (r >= range_max) return {RangeKind::kFree, range_max};
  return {RangeKind::kHit, r};
}

Time LaserScan2::end() const {
  if (isMoving() || ranges.empty()) return stamp;
  return stamp + fromSeconds(time_increment * static_cast<double>(ranges.size() - 1));
}

bool looksAhead(const LaserScan2& scan) {
  constexpr double kAhead = kPi / 6.0;  // to either side
  constexpr double kLeastReach = 0.5;   // [m]
  std::size_t ahead = 0, answered = 0;
  for (std::size_t i = 0; i < scan.ranges.size(); ++i) {
    if (std::abs(normalizeAngle(scan.T_base_sensor.yaw + scan.angle(i))) > kAhead) continue;
    ++ahead;
    answered += std::isnan(scan.ranges[i]) ? 0 : 1;
  }
  return answered * 10 > ahead && scan.range_max >= kLeastReach;
}

LaserScan2 withAtMost(std::size_t most, LaserScan2 scan) {
  const std::size_t step = (scan.ranges.size() + most - 1) / most;
  if (step <= 1) return scan;
  std::size_t kept = 0;
  for (std::size_t beam = 0; beam < scan.ranges.size(); beam += step) {
    if (scan.isMoving()) scan.moving_mounts[kept] = scan.moving_mounts[beam];
    scan.ranges[kept++] = scan.ranges[beam];
  }
  scan.ranges.resize(kept);
  if (scan.isMoving()) scan.moving_mounts.resize(kept);
  scan.time_increment *= static_cast<double>(step);
  scan.angle_increment *= static_cast<double>(step);
  return scan;
}

}  // namespace frontier_pilot
