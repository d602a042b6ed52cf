#pragma once

#include <cmath>

#include "frontier_pilot/core/geometry.h"
#include "frontier_pilot/core/time.h"

namespace frontier_pilot {

/// Where something was at a time. In which frame, and where what was, the name of the variable says.
struct StampedPose2 {
  Time stamp;
  Pose2 pose;
};

/// Where the base was and how it moved at `stamp`, by odometry.
struct MotionSample {
  Time stamp;
  Pose2 T_odom_base;
  Twist2 twist;  ///< in the base frame
};

/// Adds up signed turns across the seam at +-pi: how far something has turned since `restart` [rad], whole revolutions
/// included. Two successive yaws must be less than half a turn apart.
class TurnCounter {
 public:
  void restart(double yaw) {
    last_yaw_ = yaw;
    total_ = 0.0;
  }
  /// The total with the turn from the last yaw to this one.
  double add(double yaw) {
    total_ += angleDifference(yaw, last_yaw_);
    last_yaw_ = yaw;
    return total_;
  }
  double total() const { return total_; }

 private:
  double last_yaw_ = 0.0;
  double total_ = 0.0;
};

/// The greatest speed at which `distance` is enough to stop with `deceleration` when braking begins `reaction` [s] from
/// now: v * reaction + v^2 / (2 * deceleration) = distance. 0 if there is no distance left. Any unit of length.
inline double brakingSpeed(double distance, double deceleration, double reaction = 0.0) {
  if (!(distance > 0.0)) return 0.0;
  const double lost = deceleration * reaction;
  return std::sqrt(lost * lost + 2.0 * deceleration * distance) - lost;
}

/// Whether the base was put somewhere else between two poses: farther than `distance` [m] or turned by more than
/// `angle` [rad], which is less than half a turn.
inline bool isJump(const Pose2& from, const Pose2& to, double distance, double angle) {
  return (to.position() - from.position()).norm() > distance || std::abs(angleDifference(to.yaw, from.yaw)) > angle;
}

}  // namespace frontier_pilot
