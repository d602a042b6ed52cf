#pragma once

#include <diagnostic_updater/diagnostic_updater.h>

#include <cstdint>
#include <string>

#include "frontier_pilot/core/laser_scan.h"

namespace frontier_pilot {

/// Tells of rolling scans in the log and in /diagnostics: that the driver's times of the beams are not credible and
/// what to set, and how many scans odometry did not cover. [SCN-2]
class ScanMotionReport {
 public:
  /// To be called after each scan; `covered`: whether odometry covered its beams. Warns once of times not credible.
  void note(const BeamTiming& timing, bool covered);
  void report(diagnostic_updater::DiagnosticStatusWrapper& status) const;

 private:
  std::string problem_;
  bool warned_ = false;
  std::uint64_t uncovered_ = 0;  ///< the number of scans that odometry did not cover
};

}  // namespace frontier_pilot
