#pragma once

#include <vector>

#include "frontier_pilot/logs/scan_log.h"
#include "frontier_pilot/logs/trajectory.h"
#include "frontier_pilot/mapping/mapper.h"

namespace frontier_pilot {

/// The poses of a log's scans, one for each record.
struct LogTrajectories {
  Trajectory odometry;
  Trajectory corrected;  ///< with all that is known at the end of the log
};

/// Puts a log through a mapper, as if its scans came in now.
LogTrajectories mapLog(const ScanLog& log, Mapper& mapper);

/// Odometry bent so that it goes through `anchors`, whose stamps are ascending and are stamps of `odometry` [map].
/// Before the first and after the last anchor it hangs on that one. Without anchors it stays what it is.
Trajectory bend(const Trajectory& odometry, const Trajectory& anchors);

/// The poses alone.
std::vector<Pose2> posesOf(const Trajectory& trajectory);

}  // namespace frontier_pilot
