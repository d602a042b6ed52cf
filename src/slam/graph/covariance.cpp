#include "slam/graph/covariance.h"

#include <cmath>

namespace frontier_pilot::slam {
namespace {

/// The derivative of T_a_c with respect to T_a_b, each as (x, y, yaw) along the axes of a, for a constant T_b_c.
Eigen::Matrix3d lever(const Pose2& T_a_b, const Pose2& T_a_c) {
  const Vec2 arm = T_a_c.position() - T_a_b.position();
  Eigen::Matrix3d jacobian = Eigen::Matrix3d::Identity();
  jacobian(0, 2) = -arm.y();
  jacobian(1, 2) = arm.x();
  return jacobian;
}

}  // namespace

Eigen::Matrix3d diagonalCovariance(double position, double yaw) {
  return Eigen::Vector3d(position * position, position * position, yaw * yaw).asDiagonal();
}

Eigen::Matrix3d alongAxes(const Eigen::Matrix3d& covariance, double yaw) {
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
  turn.topLeftCorner<2, 2>() = Rotation2(yaw).matrix().transpose();
  return turn * covariance * turn.transpose();
}

Eigen::Matrix3d compounded(const Pose2& T_a_b, const Eigen::Matrix3d& of_a_b, const Pose2& T_a_c,
                           const Eigen::Matrix3d& of_b_c) {
  const Eigen::Matrix3d jacobian = lever(T_a_b, T_a_c);
  return jacobian * of_a_b * jacobian.transpose() + alongAxes(of_b_c, -T_a_b.yaw);
}

Eigen::Matrix3d reversed(const Eigen::Matrix3d& of_a_b, const Pose2& T_a_b) {
  const Eigen::Matrix3d jacobian = lever(T_a_b, Pose2());
  return alongAxes(jacobian * of_a_b * jacobian.transpose(), T_a_b.yaw);
}

double positionSigma(const Eigen::Matrix3d& covariance) {
  const double mean = 0.5 * (covariance(0, 0) + covariance(1, 1));
  const double half = 0.5 * (covariance(0, 0) - covariance(1, 1));
  return std::sqrt(mean + std::hypot(half, covariance(0, 1)));
}

double yawSigma(const Eigen::Matrix3d& covariance) { return std::sqrt(covariance(2, 2)); }

}  // namespace frontier_pilot::slam
