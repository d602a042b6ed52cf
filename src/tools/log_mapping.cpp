#include "frontier_pilot/tools/log_mapping.h"

#include <algorithm>

#include "frontier_pilot/mapping/odometry_buffer.h"

namespace frontier_pilot {
namespace {

/// An anchor, and where odometry's frame lies by it.
struct Anchor {
  Time stamp;
  Pose2 T_map_odom;
};

std::vector<Anchor> anchored(const Trajectory& odometry, const Trajectory& anchors) {
  std::vector<Anchor> out;
  auto entry = odometry.begin();
  for (const TrajectoryPose& anchor : anchors) {
    entry = std::find_if(entry, odometry.end(), [&](const TrajectoryPose& e) { return e.stamp == anchor.stamp; });
    if (entry == odometry.end()) break;
    out.push_back({anchor.stamp, anchor.pose * entry->pose.inverse()});
  }
  return out;
}

}  // namespace

LogTrajectories mapLog(const ScanLog& log, Mapper& mapper) {
  LogTrajectories out;
  for (const LogRecord& record : log.records) {
    const Time stamp = record.scan.stamp;
    mapper.insert(record.scan, record.T_odom_base, stamp);
    mapper.reviseNow();
    out.odometry.push_back({stamp, record.T_odom_base});
  }
  Trajectory anchors;
  for (const KeyframePose& keyframe : mapper.trajectory()) anchors.push_back({keyframe.stamp, keyframe.T_map_base});
  out.corrected = bend(out.odometry, anchors);
  return out;
}

Trajectory bend(const Trajectory& odometry, const Trajectory& anchors) {
  const std::vector<Anchor> fixed = anchored(odometry, anchors);
  if (fixed.empty()) return odometry;
  Trajectory out;
  std::size_t next = 0;
  for (const TrajectoryPose& entry : odometry) {
    while (next < fixed.size() && fixed[next].stamp < entry.stamp) ++next;
    const Anchor& before = fixed[next == 0 ? 0 : next - 1];
    const Anchor& after = fixed[std::min(next, fixed.size() - 1)];
    const double gap = toSeconds(after.stamp - before.stamp);
    const double share = gap > 0.0 ? toSeconds(entry.stamp - before.stamp) / gap : 0.0;
    // What is interpolated are poses near to each other: odometry's frame may lie far off.
    out.push_back({entry.stamp, interpolate(before.T_map_odom * entry.pose, after.T_map_odom * entry.pose, share)});
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
