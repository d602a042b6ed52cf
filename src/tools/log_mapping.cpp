#include "tools/log_mapping.h"

#include <algorithm>
#include <iterator>

namespace frontier_pilot::tools {
namespace {

/// Each anchor with the correction T_new_old that it requires of the trajectory at its stamp.
std::vector<StampedPose2> anchored(const logs::Trajectory& trajectory, const logs::Trajectory& anchors) {
  std::vector<StampedPose2> out;
  auto entry = trajectory.begin();
  for (const StampedPose2& anchor : anchors) {
    entry = std::find_if(entry, trajectory.end(), [&](const StampedPose2& e) { return e.stamp == anchor.stamp; });
    if (entry == trajectory.end()) break;
    out.push_back({anchor.stamp, anchor.pose * entry->pose.inverse()});
  }
  return out;
}

}  // namespace

void DriveRecorder::note(const mapping::Mapper& mapper, Time stamp, const Pose2& T_odom_base) {
  drive_.odometry.push_back({stamp, T_odom_base});
  drive_.online.push_back({stamp, mapper.T_map_odom() * T_odom_base});
  const mapping::RevisionReport& revisions = mapper.revisions();
  if (revisions.closures == drive_.closures.size()) return;
  drive_.closures.insert(drive_.closures.end(), revisions.last_closures.begin(), revisions.last_closures.end());
}

MappedDrive DriveRecorder::drive(const mapping::Mapper& mapper) const {
  MappedDrive out = drive_;
  logs::Trajectory keyframes;
  for (const slam::KeyframePose& keyframe : mapper.trajectory())
    keyframes.push_back({keyframe.stamp, keyframe.T_map_base});
  out.corrected = bend(drive_.online, keyframes);
  return out;
}

MappedDrive mapLog(const logs::ScanLog& log, mapping::Mapper& mapper) {
  DriveRecorder recorder;
  for (const logs::LogRecord& record : log.records) {
    mapper.insert(record.scan, record.T_odom_base, record.scan.stamp);
    mapper.reviseNow();
    recorder.note(mapper, record.scan.stamp, record.T_odom_base);
  }
  return recorder.drive(mapper);
}

logs::Trajectory bend(const logs::Trajectory& trajectory, const logs::Trajectory& anchors) {
  const std::vector<StampedPose2> fixed = anchored(trajectory, anchors);
  if (fixed.empty()) return trajectory;
  logs::Trajectory out;
  std::size_t next = 0;
  for (const StampedPose2& entry : trajectory) {
    while (next < fixed.size() && fixed[next].stamp < entry.stamp) ++next;
    const StampedPose2& before = fixed[next == 0 ? 0 : next - 1];
    const StampedPose2& after = fixed[std::min(next, fixed.size() - 1)];
    const double gap = toSeconds(after.stamp - before.stamp);
    const double share = gap > 0.0 ? toSeconds(entry.stamp - before.stamp) / gap : 0.0;
    // Interpolates between two corrected poses, which are close together, not between the corrections themselves: these
    // turn about the origin, which may be far away.
    out.push_back({entry.stamp, interpolate(before.pose * entry.pose, after.pose * entry.pose, share)});
  }
  return out;
}

std::vector<Pose2> posesOf(const logs::Trajectory& trajectory) {
  std::vector<Pose2> poses;
  poses.reserve(trajectory.size());
  std::transform(trajectory.begin(), trajectory.end(), std::back_inserter(poses),
                 [](const StampedPose2& entry) { return entry.pose; });
  return poses;
}

}  // namespace frontier_pilot::tools
