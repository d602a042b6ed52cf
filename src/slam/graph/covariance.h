#pragma once

#include <Eigen/Core>

#include "frontier_pilot/core/geometry.h"

namespace frontier_pilot::slam {

// A covariance of T_a_b is that of errors added to its (x, y, yaw), with x and y along the axes of a.

/// The diagonal covariance with the standard deviations `position` [m] and `yaw` [rad].
Eigen::Matrix3d diagonalCovariance(double position, double yaw);

/// `covariance` expressed along axes that are turned by `yaw` [rad] from those of a.
Eigen::Matrix3d alongAxes(const Eigen::Matrix3d& covariance, double yaw);

/// The covariance of T_a_c = T_a_b T_b_c. Smith, Self & Cheeseman, "Estimating Uncertain Spatial Relationships in
/// Robotics", 1990.
Eigen::Matrix3d compounded(const Pose2& T_a_b, const Eigen::Matrix3d& of_a_b, const Pose2& T_a_c,
                           const Eigen::Matrix3d& of_b_c);

/// The covariance of T_b_a.
Eigen::Matrix3d reversed(const Eigen::Matrix3d& of_a_b, const Pose2& T_a_b);

/// The greatest standard deviation of the position in any direction [m].
double positionSigma(const Eigen::Matrix3d& covariance);

/// The standard deviation of the yaw [rad].
double yawSigma(const Eigen::Matrix3d& covariance);

}  // namespace frontier_pilot::slam
