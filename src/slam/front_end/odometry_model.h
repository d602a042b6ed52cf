#pragma once

#include <Eigen/Core>
#include <array>

#include "frontier_pilot/core/geometry.h"
#include "frontier_pilot/slam/parameters.h"

namespace frontier_pilot::slam {

/// Standard deviations of a pose, the same in all directions.
struct PoseSigma {
  double position = 0.0;  ///< [m]
  double yaw = 0.0;       ///< [rad]
};

/// The errors of odometry, learnt from where scans were matched. Systematic errors are linear in the distance driven
/// and the angle turned, and are removed from later motions: wrong wheel radii and a wrong distance between the wheels
/// give errors of scale and a constant turn, a scanner that is not mounted where it is said to be gives a shift when
/// the robot turns (Censi et al., "Simultaneous Calibration of Odometry and Sensor Parameters for Mobile Robots",
/// 2013). They are estimated by recursive least squares; their coefficients may change slowly, as with the floor or the
/// load. What remains is random; where it is greater than assumed, the uncertainty grows.
class OdometryModel {
 public:
  explicit OdometryModel(const OdometryTrust& trust = {});

  /// A motion by odometry, in the base frame of its start, with the systematic errors removed.
  Pose2 corrected(const Pose2& motion) const;
  /// The uncertainty of a corrected motion. The variances of successive motions add up.
  PoseSigma sigma(const Pose2& motion) const;
  /// Learns from a motion by odometry that was `actual` by matched scans.
  void learn(const Pose2& motion, const Pose2& actual);

 private:
  /// The systematic error of one coordinate: its coefficients for the distance driven and the angle turned.
  struct Systematic {
    Eigen::Vector2d coefficients = Eigen::Vector2d::Zero();
    Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();
  };

  /// The end of a motion that turns constantly as odometry does not see.
  Vec2 bent(const Pose2& motion) const;
  /// Learns from the error `error` of one coordinate, due to the distance and angle `of` and to random errors of the
  /// variance `random`. Returns the squared error in proportion to what was expected.
  static double learn(Systematic& systematic, const Eigen::Vector2d& of, double error, double random);

  OdometryTrust trust_;
  std::array<Systematic, 3> systematic_;  ///< of x, y and yaw
  double position_excess_ = 1.0;          ///< variance of the position as a multiple of what `trust_` says
  double yaw_excess_ = 1.0;               ///< the same for the yaw
};

}  // namespace frontier_pilot::slam
