#pragma once

#include <deque>

#include "frontier_pilot/core/motion.h"
#include "frontier_pilot/mapping/parameters.h"

namespace frontier_pilot::mapping {

enum class OdometryLookup {
  kFound,
  kTooNew,  ///< no odometry after the stamp yet: it may still come
  kTooOld,  ///< no odometry from before the stamp is kept
  kGap,     ///< the odometry on either side is too far apart
};

/// The recent odometry, which gives the pose at a stamp.
class OdometryBuffer {
 public:
  explicit OdometryBuffer(const OdometryBufferParameters& parameters = {}) : parameters_(parameters) {}

  /// A pose that is older than the last one restarts the buffer: the clock was set back. A repeated stamp is ignored.
  void add(Time stamp, const Pose2& T_odom_base);
  /// The pose at `stamp`, interpolated between its neighbours. `T_odom_base` is written when found.
  OdometryLookup at(Time stamp, Pose2& T_odom_base) const;
  void clear() { entries_.clear(); }
  bool empty() const { return entries_.empty(); }

 private:
  OdometryBufferParameters parameters_;
  std::deque<StampedPose2> entries_;  ///< T_odom_base, oldest first
};

}  // namespace frontier_pilot::mapping
