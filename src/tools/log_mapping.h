#pragma once

#include <cstddef>
#include <vector>

#include "frontier_pilot/logs/scan_log.h"
#include "frontier_pilot/logs/trajectory.h"
#include "frontier_pilot/mapping/mapper.h"

namespace frontier_pilot::tools {

/// The result of mapping a drive: the pose of each scan, and the loops that were closed.
struct MappedDrive {
  logs::Trajectory odometry;
  logs::Trajectory online;     ///< as estimated at the time of each scan
  logs::Trajectory corrected;  ///< as estimated at the end of the drive
  std::vector<slam::LoopClosure> closures;
};

/// Records a mapper's estimates while it works.
class DriveRecorder {
 public:
  /// To be called for each scan, taken at `T_odom_base`, after the mapper has inserted it and done its revisions.
  void note(const mapping::Mapper& mapper, Time stamp, const Pose2& T_odom_base);
  /// The drive so far. Not to be called between Mapper::takeWork and Mapper::revise.
  MappedDrive drive(const mapping::Mapper& mapper) const;

 private:
  MappedDrive drive_;
};

/// Feeds a log to a mapper, as if its scans arrived live.
MappedDrive mapLog(const logs::ScanLog& log, mapping::Mapper& mapper);

/// `trajectory` corrected so that it passes through `anchors`, whose stamps must be ascending and occur in it. Between
/// two anchors their corrections are interpolated; before the first and after the last the correction of that one
/// applies. Without anchors the trajectory is unchanged.
logs::Trajectory bend(const logs::Trajectory& trajectory, const logs::Trajectory& anchors);

/// The poses of a trajectory, without their stamps.
std::vector<Pose2> posesOf(const logs::Trajectory& trajectory);

}  // namespace frontier_pilot::tools
