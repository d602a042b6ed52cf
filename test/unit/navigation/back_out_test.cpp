// The recovery that backs up along the way that the robot came.

#include <gtest/gtest.h>

#include <cmath>
#include <deque>
#include <functional>

#include "frontier_pilot/navigation/recovery.h"
#include "support/shipped_robot.h"

namespace frontier_pilot::navigation {
namespace {

/// A Waffle that backs up without a simulator: it moves exactly as commanded.
class BackOutTest : public ::testing::Test {
 protected:
  BackOutTest() {
    in_.T_map_base = {0.3, 0.0, 0.0};
    in_.track = &track_;
    in_.can_turn = false;
    in_.scan_distance = [](const Outline& /*outline*/, const Pose2& /*T_map_base*/) { return 1.0; };
    in_.path_exists = [] { return false; };
  }

  /// The seconds that it took until it was done, at most 60.
  double run() {
    const RobotModel robot = test::shippedRobot("waffle");
    Recovery recovery = backOut(RecoveryParams(), robot, kLifetime);
    for (int tick = 0; tick < 600; ++tick) {
      const RecoveryStep step = recovery(in_, Time(std::chrono::milliseconds(100 * tick)));
      EXPECT_LE(step.command.linear, 0.0);
      const Pose2 last = integrate(in_.T_map_base, step.command, kLifetime);
      EXPECT_GT(in_.scan_distance(robot.exactOutline(), last), 0.0) << "each command may be the last [FLT-2]";
      if (step.done) return 0.1 * tick;
      if (!held_) in_.T_map_base = integrate(in_.T_map_base, step.command, 0.1);
    }
    return 60.0;
  }

  static constexpr double kLifetime = 1.0;  ///< of a command [s]

  RecoveryInputs in_;
  std::deque<Pose2> track_;
  bool held_ = false;  ///< nothing that is commanded moves it
};

// [NAV-3]
TEST_F(BackOutTest, FollowsACurveBackwards) {
  for (double angle = -1.2; angle <= 1e-9; angle += 0.05) {
    track_.emplace_back(0.3 + std::sin(angle), 1.0 - std::cos(angle), angle);
  }
  in_.path_exists = [this] { return in_.T_map_base.yaw < -1.0; };
  EXPECT_LT(run(), 59.0);
  EXPECT_NEAR((in_.T_map_base.position() - Vec2(0.3, 1.0)).norm(), 1.0, 0.03) << "on the circle";
  EXPECT_LT(in_.T_map_base.yaw, -1.0);
}

TEST_F(BackOutTest, EndsAsSoonAsThereIsAPath) {
  in_.path_exists = [this] { return in_.T_map_base.x < 0.0; };
  track_ = {{-2.0, 0.0, 0.0}, {-1.0, 0.0, 0.0}, {0.0, 0.0, 0.0}, {0.3, 0.0, 0.0}};
  run();
  EXPECT_NEAR(in_.T_map_base.x, 0.0, 0.15);
}

TEST_F(BackOutTest, BacksUpStraightWhereItHadTurnedRoundAndWithoutAKnownWay) {
  track_ = {{0.6, 0.0, kPi}, {0.3, 0.0, kPi}, {0.0, 0.0, kPi}, {0.0, 0.0, 1.5}, {0.0, 0.0, 0.0}, {0.3, 0.0, 0.0}};
  EXPECT_LT(run(), 59.0);
  EXPECT_NEAR(in_.T_map_base.x, -RecoveryParams().back_up_distance, 0.05);
  in_.T_map_base = {0.3, 0.0, 0.0};
  in_.track = nullptr;
  EXPECT_LT(run(), 59.0);
  EXPECT_NEAR(in_.T_map_base.x, 0.3 - RecoveryParams().back_up_distance, 0.05);
}

TEST_F(BackOutTest, BacksUpStraightAfterACurveSoTightThatTheWayLiesBesideIt) {
  for (const double curve : {1.2, 1.7, 2.4}) {
    track_.clear();
    in_.T_map_base = {0.3, 0.0, 0.0};
    for (double angle = -curve; angle <= 1e-9; angle += 0.1) {
      track_.emplace_back(0.3 + 0.1 * std::sin(angle), 0.1 * (1.0 - std::cos(angle)), angle);
    }
    EXPECT_LT(run(), 59.0);
    EXPECT_NEAR(in_.T_map_base.x, 0.3 - RecoveryParams().back_up_distance, 0.05) << curve;
    EXPECT_NEAR(in_.T_map_base.yaw, 0.0, 1e-9) << curve;
  }
}

TEST_F(BackOutTest, StopsBeforeAnObstacleBehindItAndGivesUp) {
  in_.scan_distance = [](const Outline& outline, const Pose2& T_map_base) {
    return T_map_base.x - outline.rear() - (-0.5);
  };
  track_ = {{-2.0, 0.0, 0.0}, {-1.0, 0.0, 0.0}, {0.0, 0.0, 0.0}, {0.3, 0.0, 0.0}};
  EXPECT_LT(run(), 59.0);
  EXPECT_GT(in_.T_map_base.x - test::shippedRobot("waffle").exactOutline().rear(), -0.5);
}

// [NAV-3]
TEST_F(BackOutTest, EndsWhenItsTimeIsOverAlthoughTheWayIsFreeWhereSomethingHoldsTheWheels) {
  held_ = true;
  const double took = run();
  EXPECT_GT(took, RecoveryParams().time_allowance - 0.5);
  EXPECT_LT(took, RecoveryParams().time_allowance + 0.5);
}

// [NAV-3] [NAV-4] A wall of glass, or one that the scanner sees over.
TEST_F(BackOutTest, StopsBeforeAWallThatOnlyTheMapShows) {
  in_.has_room = [](const Pose2& T_map_base) { return T_map_base.x > 0.2; };
  EXPECT_LT(run(), 59.0);
  EXPECT_GT(in_.T_map_base.x, 0.2);
}

}  // namespace
}  // namespace frontier_pilot::navigation
