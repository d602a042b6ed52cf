#pragma once

#include <diagnostic_updater/diagnostic_updater.h>

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>

#include "frontier_pilot/core/laser_scan.h"
#include "frontier_pilot/core/motion.h"
#include "ros/common/log_interval.h"

namespace frontier_pilot {

/// What a refused scan is counted under.
inline constexpr const char* kFrozenScan = "the scanner repeats old scans while the robot moves";

/// Notices a scanner, or its driver, that sends old scans again under new stamps, one or several in turn: the same
/// ranges, value for value, although odometry says that the robot has moved. Such a scan shows where the robot was and
/// nothing of what it drives towards, and a map would be bent by it. [FLT-1]
class FrozenScanWatch {
 public:
  /// Whether `scan` repeats one of the last 64 different ones, and the robot is 0.05 m or 0.1 rad from where it was
  /// when that came first. A scan without any return is never frozen, because open ground looks the same from
  /// everywhere; what is too near to be measured, such as parts of the robot, is no return. A scan without a pose is
  /// not judged. When odometry changes between two scans by more than any such robot drives, or a stamp lies a
  /// second before the last one, a simulator for instance was reset, and the earlier scans are forgotten. Logs an
  /// error, at most one in five seconds.
  bool isFrozen(const LaserScan2& scan, const std::optional<Pose2>& T_odom_base);
  /// An error as long as the last scan was frozen.
  void report(diagnostic_updater::DiagnosticStatusWrapper& status) const;

 private:
  struct Seen {
    std::size_t hash = 0;              ///< of the ranges
    std::optional<Pose2> T_odom_base;  ///< when they came first
  };

  void notePose(Time stamp, const Pose2& T_odom_base);

  std::optional<StampedPose2> last_;  ///< of the last scan with a pose
  std::deque<Seen> seen_;             ///< the last different scans, the newest last
  bool frozen_ = false;
  std::uint64_t count_ = 0;
  LogInterval log_interval_;  ///< of the error
};

}  // namespace frontier_pilot
