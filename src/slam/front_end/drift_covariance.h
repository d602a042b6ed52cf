#pragma once

#include <Eigen/Core>
#include <optional>

#include "slam/front_end/local_slam.h"

namespace frontier_pilot::slam {

/// How far the local map may drift from keyframe to keyframe. Where a scan shows surfaces on all sides it holds the
/// robot to what is mapped; along a bare corridor there is nothing but odometry. So odometry's error stays where it
/// knows more than the scan, and goes where it knows less: with S S and I, the covariance of odometry's step and the
/// information of the surfaces, what stays is S (1 + (S I S)^4)^-2 S.
class DriftCovariance {
 public:
  explicit DriftCovariance(const LocalSlamParameters& parameters) : parameters_(parameters) {}

  /// The covariance of (x, y, yaw) of the step to `keyframe` from the last one, along the local frame's axes.
  Eigen::Matrix3d step(const Keyframe& keyframe, MatchVerdict verdict);

 private:
  Eigen::Vector3d odometrySigma(const Pose2& motion) const;
  Eigen::Matrix3d surfaceInformation(const surfaces::SurfacePoints& points) const;

  LocalSlamParameters parameters_;
  std::optional<Pose2> last_;  ///< T_local_base of the last keyframe
};

}  // namespace frontier_pilot::slam
