#pragma once

#include <Eigen/Core>

#include "frontier_pilot/core/geometry.h"

namespace frontier_pilot::slam {

// Covariances of T_a_b: of (x, y, yaw), each added to the pose's own, x and y along the axes of a.

/// With the standard deviations `position` [m] and `yaw` [rad].
Eigen::Matrix3d diagonalCovariance(double position, double yaw);

/// The same along axes that are turned by `yaw` [rad] from those of a.
Eigen::Matrix3d alongAxes(const Eigen::Matrix3d& covariance, double yaw);

/// That of T_a_c = T_a_b T_b_c. Smith, Self & Cheeseman, "Estimating Uncertain Spatial Relationships in Robotics",
/// 1990.
Eigen::Matrix3d compounded(const Pose2& T_a_b, const Eigen::Matrix3d& of_a_b, const Pose2& T_a_c,
                           const Eigen::Matrix3d& of_b_c);

/// That of T_b_a.
Eigen::Matrix3d reversed(const Eigen::Matrix3d& of_a_b, const Pose2& T_a_b);

/// The greatest standard deviation of the position in any direction [m].
double positionSigma(const Eigen::Matrix3d& covariance);

/// The standard deviation of the yaw [rad].
double yawSigma(const Eigen::Matrix3d& covariance);

}  // namespace frontier_pilot::slam
