#pragma once

#include <cstddef>
#include <vector>

#include "frontier_pilot/logs/scan_log.h"
#include "frontier_pilot/logs/trajectory.h"
#include "frontier_pilot/mapping/mapper.h"

namespace frontier_pilot::tools {

/// What a mapper made of a drive: the pose of each scan, and the loops that it closed.
struct MappedDrive {
  logs::Trajectory odometry;
  logs::Trajectory online;     ///< as it was thought to be at the time
  logs::Trajectory corrected;  ///< with all that is known at the end
  std::vector<slam::LoopClosure> closures;
};

/// Takes down what a mapper thinks while it is at work.
class DriveRecorder {
 public:
  /// To be called for each scan, taken at `T_odom_base`, once the mapper has taken it in and revised the past.
  void note(const mapping::Mapper& mapper, Time stamp, const Pose2& T_odom_base);
  /// The drive so far. Not while the mapper's work is out.
  MappedDrive drive(const mapping::Mapper& mapper) const;

 private:
  MappedDrive drive_;
};

/// Puts a log through a mapper, as if its scans came in now.
MappedDrive mapLog(const logs::ScanLog& log, mapping::Mapper& mapper);

/// `trajectory` bent so that it goes through `anchors`, whose stamps are ascending and are stamps of it. Before the
/// first and after the last anchor it hangs on that one. Without anchors it stays what it is.
logs::Trajectory bend(const logs::Trajectory& trajectory, const logs::Trajectory& anchors);

/// The poses alone.
std::vector<Pose2> posesOf(const logs::Trajectory& trajectory);

}  // namespace frontier_pilot::tools
