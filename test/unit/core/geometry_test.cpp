#include "frontier_pilot/core/geometry.h"

#include <gtest/gtest.h>

#include <random>

namespace frontier_pilot {
namespace {

Pose2 randomPose(std::mt19937& random) {
  std::uniform_real_distribution<double> metres(-50.0, 50.0);
  std::uniform_real_distribution<double> radians(-10.0, 10.0);
  return {metres(random), metres(random), radians(random)};
}

void expectNear(const Pose2& a, const Pose2& b, double tolerance) {
  EXPECT_NEAR(a.x, b.x, tolerance);
  EXPECT_NEAR(a.y, b.y, tolerance);
  EXPECT_NEAR(angleDifference(a.yaw, b.yaw), 0.0, tolerance);
}

TEST(Angles, NormalisedAnglesLieInTheHalfOpenTurnAndPointTheSameWay) {
  for (const double angle : {0.0, kPi, -kPi, 3.0 * kPi, -3.0 * kPi, 1e6, -1e6, 1e-20, -1e-20, -kPi - 1e-16}) {
    const double normal = normalizeAngle(angle);
    EXPECT_GE(normal, -kPi);
    EXPECT_LT(normal, kPi);
    EXPECT_NEAR(std::cos(normal), std::cos(angle), 1e-9);
    EXPECT_NEAR(std::sin(normal), std::sin(angle), 1e-9);
  }
}

TEST(Angles, ADifferenceIsTheShortWayAcrossTheSeam) {
  EXPECT_NEAR(angleDifference(-3.1, 3.1), 2.0 * kPi - 6.2, 1e-12);
  EXPECT_NEAR(angleDifference(3.1, -3.1), 6.2 - 2.0 * kPi, 1e-12);
}

TEST(Pose2, InverseUndoesAndCompositionAssociates) {
  std::mt19937 random(1);
  for (int i = 0; i < 1000; ++i) {
    const Pose2 a = randomPose(random);
    const Pose2 b = randomPose(random);
    const Pose2 c = randomPose(random);
    expectNear(a * a.inverse(), Pose2(), 1e-9);
    expectNear(a.inverse() * a, Pose2(), 1e-9);
    expectNear((a * b) * c, a * (b * c), 1e-9);
    const Vec2 p(1.5, -2.5);
    EXPECT_LT(((a * b) * p - a * (b * p)).norm(), 1e-9);
  }
}

TEST(Rotation2, TurnsAndMovesAsAPoseDoes) {
  const Pose2 pose(1.0, -2.0, 0.7);
  const Rotation2 rotation(pose.yaw);
  const Vec2 point(0.3, 0.4);
  EXPECT_EQ(rotation.applied(point, pose.position()), pose * point);
  EXPECT_LT((rotation * point - (pose * point - pose.position())).norm(), 1e-12);
  EXPECT_LT((rotation.matrix() * point - rotation * point).norm(), 1e-12);
  EXPECT_NEAR(bearing(rotation * Vec2(2.0, 0.0)), 0.7, 1e-12);
}

TEST(Interpolate, GoesStraightFromOnePoseToTheOtherAndTurnsTheShortWay) {
  const Pose2 a(1.0, 2.0, 3.0);
  const Pose2 b(3.0, 1.0, -3.0);
  EXPECT_EQ(interpolate(a, b, 0.0), a);
  EXPECT_LT((interpolate(a, b, 0.25).position() - Vec2(1.5, 1.75)).norm(), 1e-12);
  EXPECT_NEAR(std::abs(interpolate(a, b, 0.5).yaw), kPi, 1e-12) << "across the seam";
  EXPECT_NEAR(interpolate(a, b, 1.0).yaw, b.yaw, 1e-12);
}

TEST(Integrate, TwoHalvesOfAnArcAreTheWholeArc) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> rate(-3.0, 3.0);
  for (int i = 0; i < 1000; ++i) {
    const Twist2 twist{rate(random), i % 3 == 0 ? rate(random) * 1e-7 : rate(random)};
    const Pose2 start = randomPose(random);
    expectNear(integrate(integrate(start, twist, 0.4), twist, 0.6), integrate(start, twist, 1.0), 1e-9);
  }
}

TEST(Integrate, AFullCircleComesBackAndAHalfEndsADiameterAway) {
  const Twist2 circle{1.0, 0.5};  // radius 2 m
  expectNear(integrate({1.0, 2.0, 0.3}, circle, 4.0 * kPi), {1.0, 2.0, 0.3}, 1e-9);
  expectNear(integrate({0.0, 0.0, 0.0}, circle, 2.0 * kPi), {0.0, 4.0, kPi}, 1e-9);
}

}  // namespace
}  // namespace frontier_pilot
