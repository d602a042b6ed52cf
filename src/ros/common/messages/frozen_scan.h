#pragma once

#include <diagnostic_updater/diagnostic_updater.h>

#include <cstdint>
#include <optional>
#include <vector>

#include "frontier_pilot/core/laser_scan.h"

namespace frontier_pilot {

/// What a refused scan is counted under.
inline constexpr const char* kFrozenScan = "the scanner repeats one scan while the robot moves";

/// Notices a scanner, or its driver, that sends one scan again and again under new stamps: the same ranges, value for
/// value, although odometry says that the robot has moved. Such a scan shows where the robot was and nothing of what it
/// drives towards, and a map would be bent by it. [FLT-1]
class FrozenScanWatch {
 public:
  /// Whether `scan` repeats the one before it, and the robot has moved by 0.05 m or 0.1 rad since that was first seen.
  /// A scan without any return is never frozen, because open ground looks the same from everywhere, parts of the robot
  /// that are too near to the scanner do too; nor is one without a pose. Logs an error, throttled.
  bool isFrozen(const LaserScan2& scan, const std::optional<Pose2>& T_odom_base);
  /// An error as long as the last scan was frozen.
  void report(diagnostic_updater::DiagnosticStatusWrapper& status) const;

 private:
  std::vector<float> ranges_;        ///< of the last scan
  std::optional<Pose2> first_seen_;  ///< T_odom_base when they came first
  bool frozen_ = false;
  std::uint64_t count_ = 0;
};

}  // namespace frontier_pilot
