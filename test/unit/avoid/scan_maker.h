#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "frontier_pilot/core/laser_scan.h"

namespace frontier_pilot {

/// How a scanner is built and mounted. An upside-down one has a negative increment in the base's sense of rotation.
struct ScannerLayout {
  int beams = 360;
  double width = 2.0 * kPi;  ///< field of view [rad], centred ahead of the base, unless it is a whole turn
  bool upside_down = false;
  Pose2 mount;
};

/// A scan of nothing at all (all beams free) by such a scanner.
inline LaserScan2 emptyScan(const ScannerLayout& layout, Time stamp) {
  LaserScan2 scan;
  scan.stamp = stamp;
  scan.range_min = 0.1;
  scan.range_max = 8.0;
  scan.T_base_sensor = layout.mount;
  const bool whole_turn = layout.width > 2.0 * kPi - 1e-6;
  const double step = layout.width / (whole_turn ? layout.beams : layout.beams - 1);
  scan.angle_increment = layout.upside_down ? -step : step;
  scan.angle_min = (layout.upside_down ? 0.5 : -0.5) * layout.width - layout.mount.yaw;
  scan.ranges.assign(static_cast<std::size_t>(layout.beams), std::numeric_limits<float>::infinity());
  return scan;
}

/// The direction of a beam in the base frame, as its conversion to single precision left it.
inline double bearingOf(const LaserScan2& scan, std::size_t beam) {
  return normalizeAngle(scan.T_base_sensor.yaw + scan.angle(beam));
}

/// The beam that looks nearest to `angle` in the base frame.
inline std::size_t beamAt(const LaserScan2& scan, double angle) {
  std::size_t best = 0;
  double least = 4.0;
  for (std::size_t i = 0; i < scan.ranges.size(); ++i) {
    const double off = std::abs(std::remainder(scan.T_base_sensor.yaw + scan.angle(i) - angle, 2.0 * kPi));
    if (off < least) best = i;
    least = std::min(least, off);
  }
  return best;
}

/// Puts an obstacle of `half_width` [rad] at `distance` [m] from the sensor around `angle` in the base frame.
inline void putObstacle(LaserScan2& scan, double angle, double distance, double half_width = 0.03) {
  const std::size_t nearest = beamAt(scan, angle);
  for (std::size_t i = 0; i < scan.ranges.size(); ++i) {
    const bool inside = std::abs(angleDifference(bearingOf(scan, i), angle)) <= half_width;
    if (inside || i == nearest) scan.ranges[i] = static_cast<float>(distance);
  }
}

}  // namespace frontier_pilot
