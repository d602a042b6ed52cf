#include "mapping/odometry_buffer.h"

#include <algorithm>

#include "frontier_pilot/core/bounds.h"

namespace frontier_pilot::mapping {

void OdometryBuffer::add(Time stamp, const Pose2& T_odom_base) {
  if (!entries_.empty() && stamp == entries_.back().stamp) return;
  if (!entries_.empty() && stamp < entries_.back().stamp) entries_.clear();
  entries_.push_back({stamp, T_odom_base});
  // Limited in number as well: stamps may be only nanoseconds apart. [FLT-1]
  while (toSeconds(stamp - entries_.front().stamp) > parameters_.length || entries_.size() > bounds::kMostOdometry) {
    entries_.pop_front();
  }
}

OdometryLookup OdometryBuffer::at(Time stamp, Pose2& T_odom_base) const {
  const auto after = std::lower_bound(entries_.begin(), entries_.end(), stamp,
                                      [](const StampedPose2& entry, Time time) { return entry.stamp < time; });
  if (after == entries_.end()) return OdometryLookup::kTooNew;
  if (after->stamp == stamp) {
    T_odom_base = after->pose;
    return OdometryLookup::kFound;
  }
  if (after == entries_.begin()) return OdometryLookup::kTooOld;
  const auto before = std::prev(after);
  const double gap = toSeconds(after->stamp - before->stamp);
  if (gap > parameters_.max_gap) return OdometryLookup::kGap;
  T_odom_base = interpolate(before->pose, after->pose, toSeconds(stamp - before->stamp) / gap);
  return OdometryLookup::kFound;
}

}  // namespace frontier_pilot::mapping
