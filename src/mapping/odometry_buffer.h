#pragma once

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
  explicit OdometryBuffer(const OdometryBufferParameters& parameters = {})
      : parameters_(parameters), track_(fromSeconds(parameters.length)) {}

  /// See PoseTrack::add.
  void add(Time stamp, const Pose2& T_odom_base) { track_.add(stamp, T_odom_base); }
  /// The pose at `stamp`, interpolated between its neighbours. `T_odom_base` is written when found.
  OdometryLookup at(Time stamp, Pose2& T_odom_base) const;
  void clear() { track_.clear(); }
  bool empty() const { return track_.empty(); }
  const PoseTrack& track() const { return track_; }

 private:
  OdometryBufferParameters parameters_;
  PoseTrack track_;  ///< T_odom_base
};

}  // namespace frontier_pilot::mapping
