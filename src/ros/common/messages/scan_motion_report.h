#pragma once

#include <diagnostic_updater/diagnostic_updater.h>

#include <cstdint>
#include <optional>
#include <string>

#include "frontier_pilot/core/laser_scan.h"
#include "ros/common/log_interval.h"
#include "ros/common/messages/frozen_scan.h"

namespace frontier_pilot {

/// Tells in the log and in /diagnostics what does not fit between the scans and the motion of the robot: that the
/// driver's times of the beams are not credible and what to set, how many scans odometry did not cover, and that the
/// scanner repeats old scans while the robot moves. Up to five scans that come before odometry are counted, but not
/// warned of. [SCN-2]
class ScanMotionReport {
 public:
  /// Puts the beams of `scan` where the robot was, referred to its end. Returns whether it may be used: not if it is
  /// frozen.
  bool place(ScanPlacer& placer, LaserScan2& scan);
  /// To be called after each scan whose beams have been placed; `covered`: whether odometry covered them, `T_odom_base`
  /// at its stamp. Warns once of times not credible. Returns as `place`.
  bool note(const BeamTiming& timing, bool covered, const LaserScan2& scan, const std::optional<Pose2>& T_odom_base);
  void report(diagnostic_updater::DiagnosticStatusWrapper& status) const;

 private:
  FrozenScanWatch frozen_;
  bool covered_ = false;  ///< odometry has covered a scan
  std::string problem_;
  bool warned_ = false;
  std::uint64_t uncovered_ = 0;  ///< the number of scans that odometry did not cover
  LogInterval log_interval_;     ///< of the line about them
};

}  // namespace frontier_pilot
