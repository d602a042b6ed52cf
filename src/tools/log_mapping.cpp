#include "frontier_pilot/tools/log_mapping.h"

#include <algorithm>

namespace frontier_pilot {

LogTrajectories mapLog(const ScanLog& log, Mapper& mapper) {
  LogTrajectories out;
  for (const LogRecord& record : log.records) {
    const Time stamp = record.scan.stamp;
    mapper.insert(record.scan, record.T_odom_base, stamp);
    out.odometry.push_back({stamp, record.T_odom_base});
    out.corrected.push_back({stamp, mapper.T_map_odom() * record.T_odom_base});
  }
  return out;
}

std::vector<Pose2> posesOf(const Trajectory& trajectory) {
  std::vector<Pose2> poses;
  poses.reserve(trajectory.size());
  std::transform(trajectory.begin(), trajectory.end(), std::back_inserter(poses),
                 [](const TrajectoryPose& entry) { return entry.pose; });
  return poses;
}

}  // namespace frontier_pilot
