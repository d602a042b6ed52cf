#include "mapping/odometry_buffer.h"

#include <algorithm>

namespace frontier_pilot::mapping {

OdometryLookup OdometryBuffer::at(Time stamp, Pose2& T_odom_base) const {
  const std::deque<StampedPose2>& entries = track_.poses();
  const auto after = std::lower_bound(entries.begin(), entries.end(), stamp,
                                      [](const StampedPose2& entry, Time time) { return entry.stamp < time; });
  if (after == entries.end()) return OdometryLookup::kTooNew;
  if (after->stamp == stamp) {
    T_odom_base = after->pose;
    return OdometryLookup::kFound;
  }
  if (after == entries.begin()) return OdometryLookup::kTooOld;
  const auto before = std::prev(after);
  const double gap = toSeconds(after->stamp - before->stamp);
  if (gap > parameters_.max_gap) return OdometryLookup::kGap;
  T_odom_base = interpolate(before->pose, after->pose, toSeconds(stamp - before->stamp) / gap);
  return OdometryLookup::kFound;
}

}  // namespace frontier_pilot::mapping
