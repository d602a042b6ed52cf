#pragma once

#include <Eigen/Core>
#include <optional>

#include "slam/front_end/local_slam.h"

namespace frontier_pilot::slam {

/// The drift of the local map from keyframe to keyframe. Where a scan shows surfaces on all sides, matching determines
/// the pose fully; along a bare corridor only odometry does. So odometry's error remains in directions in which
/// odometry is more certain than the scan, and vanishes in the others: with the covariance S S of odometry's step and
/// the information I of the surfaces, S (1 + (S I S)^4)^-2 S remains.
class DriftCovariance {
 public:
  explicit DriftCovariance(const LocalSlamParameters& parameters) : parameters_(parameters) {}

  /// The covariance of (x, y, yaw) of the step to `keyframe` from the last one, along the local frame's axes. `track`:
  /// how its pose was found.
  Eigen::Matrix3d step(const Keyframe& keyframe, const Track& track);

 private:
  Eigen::Vector3d odometrySigma(const Pose2& motion) const;
  Eigen::Matrix3d surfaceInformation(const surfaces::SurfacePoints& points) const;

  LocalSlamParameters parameters_;
  std::optional<Pose2> last_;  ///< T_local_base of the last keyframe
};

}  // namespace frontier_pilot::slam
