#include "slam/front_end/drift_covariance.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <utility>

namespace frontier_pilot {
namespace {

constexpr double kSpacing = 0.1;  // [m]

/// The two walls of a corridor 2 m wide that runs at `yaw` in the base frame, ahead of the robot, as far as a scanner
/// sees.
surfaces::SurfacePoints corridor(double yaw) {
  const Pose2 turn(0.0, 0.0, yaw);
  surfaces::SurfacePoints points;
  for (int i = 0; i <= 80; ++i) {
    for (const double side : {-1.0, 1.0}) {
      points.push_back({turn * Vec2(kSpacing * i, side), turn * Vec2(0.0, -side)});
    }
  }
  return points;
}

/// A room around the robot.
surfaces::SurfacePoints room() {
  surfaces::SurfacePoints points = corridor(0.0);
  for (const surfaces::SurfacePoint& point : corridor(0.5 * kPi)) points.push_back(point);
  return points;
}

slam::Keyframe keyframeAt(const Pose2& T_local_base, surfaces::SurfacePoints points) {
  slam::Keyframe keyframe;
  keyframe.T_local_base = T_local_base;
  keyframe.points = std::move(points);
  return keyframe;
}

slam::Track trackOf(slam::MatchVerdict verdict) {
  slam::Track track;
  track.verdict = verdict;
  return track;
}

/// The standard deviations of the position after a step of 0.2 m with a turn: the least and the greatest.
Eigen::Vector2d sigmasOf(const surfaces::SurfacePoints& points) {
  slam::DriftCovariance drift((slam::LocalSlamParameters()));
  drift.step(keyframeAt(Pose2(), points), trackOf(slam::MatchVerdict::kFirst));
  const Eigen::Matrix3d covariance =
      drift.step(keyframeAt(Pose2(0.2, 0.0, 0.2), points), trackOf(slam::MatchVerdict::kMatched));
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(Eigen::Matrix2d(covariance.topLeftCorner<2, 2>()))
      .eigenvalues()
      .cwiseMax(0.0)
      .cwiseSqrt();
}

constexpr double kOdometry = 0.06 * 0.2;  // [m], standard deviation of odometry after the step

TEST(DriftCovariance, MAP_1_IsOdometrysAlongACorridorWhicheverWayThatRuns) {
  for (int degrees = 0; degrees < 180; degrees += 5) {
    const Eigen::Vector2d sigmas = sigmasOf(corridor(degrees * kPi / 180.0));
    EXPECT_NEAR(sigmas(1), kOdometry, 0.01 * kOdometry) << degrees << " degrees";
    EXPECT_LT(sigmas(0), 1e-3 * kOdometry) << degrees << " degrees";
  }
}

TEST(DriftCovariance, MAP_1_IsNextToNothingWhereWallsAreOnAllSides) {
  EXPECT_LT(sigmasOf(room())(1), 1e-3 * kOdometry);
}

TEST(DriftCovariance, MAP_1_IsThatOfARobotPickedUpWhereTheMapIsBegunAnew) {
  slam::DriftCovariance drift((slam::LocalSlamParameters()));
  EXPECT_TRUE(drift.step(keyframeAt(Pose2(), room()), trackOf(slam::MatchVerdict::kFirst)).isZero());
  const Eigen::Matrix3d lost = drift.step(keyframeAt(Pose2(0.2, 0.0, 0.0), room()), trackOf(slam::MatchVerdict::kLost));
  EXPECT_GT(lost(0, 0), 1.0);
  EXPECT_GT(lost(2, 2), 0.2);
}

TEST(DriftCovariance, MAP_1_IsThatOfThePoseWhereAScanExtendsTheMap) {
  slam::DriftCovariance drift((slam::LocalSlamParameters()));
  drift.step(keyframeAt(Pose2(), room()), trackOf(slam::MatchVerdict::kFirst));
  slam::Track extended = trackOf(slam::MatchVerdict::kExtended);
  extended.T_local_base.covariance = Eigen::Vector3d(0.01, 0.02, 0.003).asDiagonal();
  EXPECT_EQ(drift.step(keyframeAt(Pose2(1.0, 0.0, 0.0), room()), extended), extended.T_local_base.covariance);
}

}  // namespace
}  // namespace frontier_pilot
