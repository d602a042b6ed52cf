#pragma once

#include <cmath>
#include <deque>
#include <optional>

#include "frontier_pilot/core/geometry.h"
#include "frontier_pilot/core/time.h"

namespace frontier_pilot {

/// A pose and the time at which it holds. The name of the variable tells the frames.
struct StampedPose2 {
  Time stamp;
  Pose2 pose;
};

/// The poses of the last seconds, in the order of their stamps.
class PoseTrack {
 public:
  /// `kept`: for how long a pose is kept.
  explicit PoseTrack(Duration kept = std::chrono::seconds(2)) : kept_(kept) {}

  /// A pose that is older than the last one restarts the track: the clock was set back. A repeated stamp is ignored.
  void add(Time stamp, const Pose2& pose);
  /// Corrects the last pose. There must be one.
  void correct(const Pose2& pose) { poses_.back().pose = pose; }
  void clear() { poses_.clear(); }
  bool empty() const { return poses_.empty(); }
  const std::deque<StampedPose2>& poses() const { return poses_; }
  /// The first pose at `stamp` or later; the end of poses() if there is none.
  std::deque<StampedPose2>::const_iterator notBefore(Time stamp) const;
  /// The pose at `stamp`, interpolated between its neighbours; before the first and after the last that one. Nothing if
  /// there is none.
  std::optional<Pose2> nearest(Time stamp) const;
  /// How far `stamp` is from the nearest pose; zero between two of them that are less than `gap` apart.
  Duration away(Time stamp, Duration gap) const;

 private:
  Duration kept_;
  std::deque<StampedPose2> poses_;
};

/// Where the base was and how it moved at `stamp`, according to odometry.
struct MotionSample {
  Time stamp;
  Pose2 T_odom_base;
  Twist2 twist;  ///< in the base frame
};

/// Unwraps a yaw: how far something has turned since `restart` [rad], signed, whole revolutions included. Two
/// successive yaws must be less than half a turn apart.
class TurnCounter {
 public:
  void restart(double yaw) {
    last_yaw_ = yaw;
    total_ = 0.0;
  }
  /// Adds the turn from the last yaw to this one, and returns the total.
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

/// How far a robot gets that brakes from `speed` with `deceleration`. Works in [m] or [rad].
inline double brakingDistance(double speed, double deceleration) { return 0.5 * speed * speed / deceleration; }

/// The greatest speed from which a robot that begins to brake in `reaction` [s] with `deceleration` stops within
/// `distance`: v * reaction + v^2 / (2 * deceleration) = distance. 0 if no distance is left. Works in [m] or [rad].
inline double brakingSpeed(double distance, double deceleration, double reaction = 0.0) {
  if (!(distance > 0.0)) return 0.0;
  const double lost = deceleration * reaction;
  return std::sqrt(lost * lost + 2.0 * deceleration * distance) - lost;
}

/// Whether two successive poses are too far apart for the base to have driven from one to the other: by more than
/// `distance` [m], or turned by more than `angle` [rad], which must be less than half a turn.
inline bool isJump(const Pose2& from, const Pose2& to, double distance, double angle) {
  return (to.position() - from.position()).norm() > distance || std::abs(angleDifference(to.yaw, from.yaw)) > angle;
}

}  // namespace frontier_pilot
