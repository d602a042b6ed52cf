#include "slam/front_end/odometry_model.h"

#include <algorithm>
#include <cmath>

#include "frontier_pilot/core/motion.h"

namespace frontier_pilot::slam {
namespace {

constexpr double kMatchPosition = 0.03;  ///< standard deviation of the motion between two matches [m]
constexpr double kMatchYaw = 0.01;       ///< [rad]
constexpr double kWalk = 1e-6;           ///< growth of the coefficients' variances with each metre and radian
constexpr double kOutlier = 9.0;         ///< squared errors this much greater than expected are slip, and not learnt
constexpr double kPace = 0.05;           ///< share of a new error in the running mean
constexpr double kMostExcess = 9.0;

Eigen::Vector2d drivenAndTurned(const Pose2& motion) { return {motion.x, motion.yaw}; }

/// What moves a motion sideways: only a turn. A constant turn of odometry moves it too, but that follows from the yaw.
Eigen::Vector2d turnedOnly(const Pose2& motion) { return {0.0, motion.yaw}; }

double follow(double excess, double squared) {
  return std::clamp(excess * (1.0 + kPace * (std::min(squared, kOutlier) - 1.0)), 1.0, kMostExcess);
}

}  // namespace

OdometryModel::OdometryModel(const OdometryTrust& trust) : trust_(trust) {
  const Eigen::Vector2d position(trust.distance, trust.distance_turn);
  const Eigen::Vector2d yaw(trust.yaw_distance, trust.yaw_turn);
  systematic_[0].covariance = position.array().square().matrix().asDiagonal();
  systematic_[1].covariance = systematic_[0].covariance;
  systematic_[2].covariance = yaw.array().square().matrix().asDiagonal();
}

Vec2 OdometryModel::bent(const Pose2& motion) const {
  // The yaw that odometry misses on the way makes it a chord of half that angle.
  return Rotation2(0.5 * systematic_[2].coefficients(0) * motion.x) * motion.position();
}

Pose2 OdometryModel::corrected(const Pose2& motion) const {
  const Vec2 position = bent(motion);
  return {position.x() + systematic_[0].coefficients.dot(drivenAndTurned(motion)),
          position.y() + systematic_[1].coefficients.dot(turnedOnly(motion)),
          normalizeAngle(motion.yaw + systematic_[2].coefficients.dot(drivenAndTurned(motion)))};
}

PoseSigma OdometryModel::sigma(const Pose2& motion) const {
  const double driven = motion.position().norm();
  const double turned = std::abs(motion.yaw);
  const double position = square(trust_.distance) * driven + square(trust_.distance_turn) * turned;
  const double yaw = square(trust_.yaw_distance) * driven + square(trust_.yaw_turn) * turned;
  return {std::sqrt(position_excess_ * position), std::sqrt(yaw_excess_ * yaw)};
}

void OdometryModel::learn(const Pose2& motion, const Pose2& actual) {
  const PoseSigma random = sigma(motion);
  const double position = square(random.position) + square(kMatchPosition);
  const double yaw = square(random.yaw) + square(kMatchYaw);
  const Vec2 error = actual.position() - bent(motion);
  const double along = learn(systematic_[0], drivenAndTurned(motion), error.x(), position);
  const double across = learn(systematic_[1], turnedOnly(motion), error.y(), position);
  const double turn = angleDifference(actual.yaw, motion.yaw);
  position_excess_ = follow(position_excess_, 0.5 * (along + across));
  yaw_excess_ = follow(yaw_excess_, learn(systematic_[2], drivenAndTurned(motion), turn, yaw));
}

double OdometryModel::learn(Systematic& systematic, const Eigen::Vector2d& of, double error, double random) {
  Eigen::Matrix2d& covariance = systematic.covariance;
  covariance.diagonal().array() += kWalk * of.norm();
  const Eigen::Vector2d spread = covariance * of;
  const double expected = of.dot(spread) + random;
  const double surprise = error - systematic.coefficients.dot(of);
  const double squared = square(surprise) / expected;
  if (squared > kOutlier) return squared;
  systematic.coefficients += spread / expected * surprise;
  covariance -= spread * spread.transpose() / expected;
  return squared;
}

}  // namespace frontier_pilot::slam
