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

/// The poses alone.
std::vector<Pose2> posesOf(const Trajectory& trajectory);

}  // namespace frontier_pilot
