#pragma once

#include "frontier_pilot/core/geometry.h"
#include "frontier_pilot/sim/parameters.h"
#include "sim/random.h"

namespace frontier_pilot::sim {

/// Simulated wheel odometry: dead reckoning from zero at the start, with drift if wanted.
class Odometry {
 public:
  Odometry(const OdometryParameters& parameters, bool noisy, const Random& random);

  /// The base drove an arc of `length` [m] (negative in reverse), turning by `turn` [rad], within `seconds` [s].
  void move(double length, double turn, double seconds);
  /// Resets the pose to zero; the sequence of noise continues.
  void reset();

  /// T_odom_base.
  const Pose2& pose() const { return pose_; }
  /// The velocity as driven, without noise.
  const Twist2& twist() const { return twist_; }

 private:
  OdometryParameters parameters_;
  bool noisy_;
  Random random_;
  double distance_factor_ = 1.0;
  double turn_factor_ = 1.0;
  double drift_ = 0.0;  ///< [rad/m]
  Pose2 pose_;
  Twist2 twist_;
};

}  // namespace frontier_pilot::sim
