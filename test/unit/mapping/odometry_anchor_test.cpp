#include "frontier_pilot/mapping/odometry_anchor.h"

#include <gtest/gtest.h>

namespace frontier_pilot {
namespace {

/// Odometry of a robot that drives along x at 0.5 m/s, twenty messages a second, while its driver works.
class OdometryAnchorTest : public ::testing::Test {
 protected:
  std::optional<Pose2> hear(const Pose2& T_odom_base, double after = 0.05) {
    now += fromSeconds(after);
    return anchor.follow(now, T_odom_base);
  }
  /// Drives for `messages`, and gives the last smooth pose.
  std::optional<Pose2> drive(int messages) {
    std::optional<Pose2> smooth;
    for (int i = 0; i < messages; ++i) smooth = hear(pose = pose * Pose2(0.025, 0.0, 0.0));
    return smooth;
  }
  void expectAt(double x, const std::optional<Pose2>& smooth, double tolerance = 1e-9) {
    ASSERT_TRUE(smooth);
    EXPECT_NEAR(smooth->x, x, tolerance);
    EXPECT_NEAR(smooth->y, 0.0, tolerance);
    EXPECT_NEAR(smooth->yaw, 0.0, tolerance);
  }

  mapping::OdometryAnchor anchor;
  Time now = timeFromSeconds(100.0);
  Pose2 pose;
};

TEST_F(OdometryAnchorTest, GivesOdometryThatDoesNotJumpAsItIs) {
  expectAt(1.0, drive(40));
  EXPECT_EQ(anchor.T_smooth_odom(), Pose2());
  EXPECT_EQ(anchor.resets(), 0U);
}

// [FLT-1]
TEST_F(OdometryAnchorTest, FLT_1_LeavesOutASingleMessageThatNoRobotCouldHaveDrivenTo) {
  drive(40);
  EXPECT_FALSE(hear(Pose2(20.0, 0.0, 0.0)));
  expectAt(1.025, drive(1));
  EXPECT_EQ(anchor.resets(), 0U);
}

// [FLT-1]
TEST_F(OdometryAnchorTest, FLT_1_KeepsTheRobotWhereItIsWhenTheDriverCountsFromTheOriginAgain) {
  pose = Pose2(12.0, 0.0, 0.0);
  drive(40);
  pose = Pose2();
  EXPECT_FALSE(drive(1));
  EXPECT_FALSE(drive(1));
  expectAt(13.05, drive(1));
  EXPECT_EQ(anchor.resets(), 1U);
  EXPECT_NEAR(anchor.lastJump().distance, 12.975, 1e-9);
  EXPECT_NEAR(anchor.lastJump().seconds, 0.05, 1e-9);
  expectAt(13.55, drive(20));
  EXPECT_NEAR((anchor.T_smooth_odom() * pose).x, 13.55, 1e-9) << "the frame follows: poses in the map stay";
}

// [FLT-1]
TEST_F(OdometryAnchorTest, FLT_1_KeepsTheHeadingWhenOnlyThatWasReset) {
  hear(Pose2(0.0, 0.0, 2.0));
  for (int i = 0; i < 3; ++i) hear(Pose2());
  EXPECT_EQ(anchor.resets(), 1U);
  EXPECT_NEAR(anchor.T_smooth_odom().yaw, 2.0, 1e-9);
}

TEST_F(OdometryAnchorTest, BelievesWhatMayBeDrivenWhileMessagesAreLost) {
  drive(40);
  expectAt(6.0, hear(Pose2(6.0, 0.0, 0.0), 10.0));
  EXPECT_EQ(anchor.resets(), 0U);
}

// [FLT-1]
TEST_F(OdometryAnchorTest, FLT_1_TellsARestartFromAWayHomeAfterASilence) {
  pose = Pose2(2.0, 0.0, 0.0);
  drive(40);
  EXPECT_FALSE(hear(Pose2(), 5.0)) << "it might have driven, but not to the millimetre";
  EXPECT_FALSE(hear(Pose2(0.01, 0.0, 0.0)));
  expectAt(3.03, hear(Pose2(0.03, 0.0, 0.0)));
}

// [FLT-1]
TEST_F(OdometryAnchorTest, FLT_1_FollowsTrustedOdometryWhereItStaysAfterAJumpAndNotASingleMessage) {
  mapping::OdometryAnchorParameters parameters;
  parameters.trusted = true;
  anchor = mapping::OdometryAnchor(parameters);
  drive(40);
  EXPECT_FALSE(hear(Pose2(20.0, 0.0, 0.0)));
  expectAt(1.025, drive(1));
  for (int i = 0; i < 2; ++i) EXPECT_FALSE(hear(Pose2(-5.0, 0.0, 0.0)));
  expectAt(-5.0, hear(Pose2(-5.0, 0.0, 0.0)));
  EXPECT_EQ(anchor.resets(), 1U) << "said all the same";
}

TEST_F(OdometryAnchorTest, BelievesStampsThatStandStillAsASlowClockGivesThem) {
  for (int i = 0; i < 100; ++i) EXPECT_TRUE(hear(Pose2(0.1 * i, 0.0, 0.0), i % 10 == 0 ? 1.0 : 0.0)) << i;
  EXPECT_EQ(anchor.resets(), 0U);
}

// [FLT-1]
TEST_F(OdometryAnchorTest, FLT_1_FollowsOneOfTwoPublishersThatTakeTurns) {
  for (int i = 0; i < 50; ++i) {
    expectAt(0.025 * (i + 1), drive(1));
    EXPECT_FALSE(hear(Pose2(30.0, 4.0, 1.0), 0.01)) << i;
  }
  EXPECT_EQ(anchor.resets(), 0U);
}

TEST_F(OdometryAnchorTest, ComparesNothingAcrossAJumpOfTheClockAndIsOneWithOdometryAfterAReset) {
  drive(40);
  anchor.forgetTime();
  expectAt(-9.0, hear(Pose2(-9.0, 0.0, 0.0)));
  for (int i = 0; i < 3; ++i) hear(Pose2(5.0, 0.0, 0.0));
  EXPECT_FALSE(anchor.T_smooth_odom() == Pose2());
  anchor.reset();
  EXPECT_EQ(anchor.T_smooth_odom(), Pose2());
}

}  // namespace
}  // namespace frontier_pilot
