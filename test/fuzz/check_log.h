#pragma once

#include <cmath>
#include <sstream>

#include "frontier_pilot/logs/scan_log.h"
#include "fuzz/fuzz.h"

namespace frontier_pilot::fuzz {

inline bool isFinite(const Pose2& pose) {
  return std::isfinite(pose.x) && std::isfinite(pose.y) && std::isfinite(pose.yaw);
}

/// What holds for a log that was accepted.
inline void checkLog(const logs::ScanLog& log) {
  require(!log.records.empty(), "a log that is accepted holds a scan");
  for (const logs::LogRecord& record : log.records) {
    const LaserScan2& scan = record.scan;
    require(scan.ranges.size() >= 2, "a scan has at least two ranges");
    require(isFinite(record.T_odom_base) && isFinite(scan.T_base_sensor), "poses are finite");
    require(std::isfinite(scan.angle_min) && std::isfinite(scan.angle_increment), "angles are finite");
    require(scan.angle_increment != 0.0, "there is an angle between two beams");
    require(scan.range_max > 0.0, "the longest range is positive");
  }
}

/// Reads the input as a log by `read`, which may refuse it.
template <class Read>
void readLog(const std::uint8_t* data, std::size_t size, Read read) {
  std::istringstream file(textOf(data, size));
  try {
    checkLog(read(file));
  } catch (const logs::LogError&) {
  }
}

}  // namespace frontier_pilot::fuzz
