#include "frontier_pilot/mapping/local_drift.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "covariance.h"

namespace frontier_pilot {

Eigen::Matrix3d LocalDrift::step(const Keyframe& keyframe, MatchVerdict verdict) {
  const Pose2 motion = last_ ? last_->inverse() * keyframe.T_local_base : Pose2();
  const bool first = !last_;
  last_ = keyframe.T_local_base;
  if (first) return Eigen::Matrix3d::Zero();
  // Nothing joins what was begun anew to what was before, but that the robot did not fly.
  constexpr double kLostPosition = 1.5;  // [m]
  constexpr double kLostYaw = 0.5;       // [rad]
  if (verdict == MatchVerdict::kLost) return diagonalCovariance(kLostPosition, kLostYaw);
  const Eigen::Matrix3d error = odometryError(motion);
  const Eigen::Matrix3d certain = error.inverse();
  const Eigen::Matrix3d open = (certain + surfaceInformation(keyframe.points)).inverse() * certain;
  return alongAxes(open * error * open.transpose(), -keyframe.T_local_base.yaw);
}

Eigen::Matrix3d LocalDrift::odometryError(const Pose2& motion) const {
  const OdometryTrust& trust = parameters_.tracker.odometry;
  constexpr double kLeast = 1e-4;
  const double driven = motion.position().norm();
  return diagonalCovariance(std::max(kLeast, trust.distance * driven),
                            std::max(kLeast, trust.yaw_distance * driven + trust.yaw_turn * std::abs(motion.yaw)));
}

Eigen::Matrix3d LocalDrift::surfaceInformation(const SurfacePoints& points) const {
  const RefinementParameters& refinement = parameters_.tracker.refinement;
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  for (const SurfacePoint& point : points) {
    const Vec2& n = point.normal;
    const Eigen::Vector3d along(n.x(), n.y(), point.position.x() * n.y() - point.position.y() * n.x());
    sum += along * along.transpose();
  }
  return refinement.independence / (refinement.noise * refinement.noise) * sum;
}

}  // namespace frontier_pilot
