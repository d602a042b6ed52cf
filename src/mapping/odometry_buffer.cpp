#include "mapping/odometry_buffer.h"

#include <iterator>

namespace frontier_pilot::mapping {

OdometryLookup OdometryBuffer::at(Time stamp, Pose2& T_odom_base) const {
  const auto after = track_.notBefore(stamp);
  if (after == track_.poses().end()) return OdometryLookup::kTooNew;
  if (after->stamp != stamp) {
    if (after == track_.poses().begin()) return OdometryLookup::kTooOld;
    if (toSeconds(after->stamp - std::prev(after)->stamp) > parameters_.max_gap) return OdometryLookup::kGap;
  }
  T_odom_base = *track_.nearest(stamp);
  return OdometryLookup::kFound;
}

}  // namespace frontier_pilot::mapping
