#include "slam/front_end/drift_covariance.h"

#include <Eigen/Eigenvalues>
#include <cmath>

#include "slam/graph/covariance.h"

namespace frontier_pilot::slam {
namespace {

/// (1 + K^4)^-2 of a symmetric K, eigenvalue by eigenvalue: a direction that is hardly known must not be lost in the
/// rounding errors of one that is known a million times better.
Eigen::Matrix3d unknownShare(const Eigen::Matrix3d& known) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> directions(known);
  const Eigen::Array3d squared = directions.eigenvalues().array().square();
  const Eigen::Vector3d share = (1.0 + squared.square()).square().inverse();
  return directions.eigenvectors() * share.asDiagonal() * directions.eigenvectors().transpose();
}

}  // namespace

Eigen::Matrix3d DriftCovariance::step(const Keyframe& keyframe, const Track& track) {
  const Pose2 motion = last_ ? last_->inverse() * keyframe.T_local_base : Pose2();
  const bool first = !last_;
  last_ = keyframe.T_local_base;
  if (first) return Eigen::Matrix3d::Zero();
  // No match connects the new submap to the earlier ones: only how far a robot may have been moved bounds the error.
  constexpr double kLostPosition = 1.5;  // [m]
  constexpr double kLostYaw = 0.5;       // [rad]
  if (track.verdict == MatchVerdict::kLost) return diagonalCovariance(kLostPosition, kLostYaw);
  if (track.verdict == MatchVerdict::kExtended) return track.T_local_base.covariance;
  const Eigen::Matrix3d sigma = odometrySigma(motion).asDiagonal();
  if (track.verdict == MatchVerdict::kCarried) return sigma * sigma;
  const Eigen::Matrix3d known = sigma * surfaceInformation(keyframe.points) * sigma;
  const Eigen::Matrix3d open = sigma * unknownShare(known) * sigma;
  return alongAxes(open, -keyframe.T_local_base.yaw);
}

Eigen::Vector3d DriftCovariance::odometrySigma(const Pose2& motion) const {
  const OdometryTrust& trust = parameters_.tracker.odometry;
  const double driven = motion.position().norm();
  const double position = trust.distance * driven;
  return {position, position, trust.yaw_distance * driven + trust.yaw_turn * std::abs(motion.yaw)};
}

Eigen::Matrix3d DriftCovariance::surfaceInformation(const surfaces::SurfacePoints& points) const {
  // The points count as independent, because the information is only compared with odometry's. The noise is taken to be
  // greater than it is, so that small errors in the normals of a corridor's walls do not look like features.
  constexpr double kNoise = 0.02;  // [m]
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  for (const surfaces::SurfacePoint& point : points) {
    const Vec2& n = point.normal;
    const Eigen::Vector3d along(n.x(), n.y(), point.position.x() * n.y() - point.position.y() * n.x());
    sum += along * along.transpose();
  }
  return sum / (kNoise * kNoise);
}

}  // namespace frontier_pilot::slam
