#include "navigation/motion_predictor.h"

#include <gtest/gtest.h>

#include "support/floors/driven_robot.h"

namespace frontier_pilot {
namespace {

Time at(double seconds) { return Time{} + fromSeconds(seconds); }

RobotLimits limits() {
  RobotLimits limits;
  limits.max_linear_acc = 1.0;
  return limits;
}

TEST(MotionPredictor, KeepsTheTwistOfABaseThatWasToldNothing) {
  const navigation::MotionPredictor predictor(limits());
  const auto motion = predictor.predict({at(1.0), Pose2(1.0, 2.0, kPi / 2.0)}, {0.2, 0.0}, at(1.5));
  EXPECT_NEAR(motion.T_map_base.x, 1.0, 1e-9);
  EXPECT_NEAR(motion.T_map_base.y, 2.1, 1e-9);
  EXPECT_EQ(motion.twist, (Twist2{0.2, 0.0}));
}

TEST(MotionPredictor, GivesBackAPoseThatIsNotOld) {
  navigation::MotionPredictor predictor(limits());
  predictor.commanded({0.2, 1.0}, at(0.9));
  const auto motion = predictor.predict({at(1.0), Pose2(1.0, 2.0, 0.3)}, {0.1, 0.0}, at(1.0));
  EXPECT_EQ(motion.T_map_base.x, 1.0);
  EXPECT_EQ(motion.twist, (Twist2{0.1, 0.0}));
}

// From rest at 1 m/s^2 for 0.2 s, and then 0.2 m/s for 0.2 s.
TEST(MotionPredictor, SpeedsUpToTheCommandAsTheLimitsAllow) {
  navigation::MotionPredictor predictor(limits());
  predictor.commanded({0.2, 0.0}, at(0.5));
  const auto motion = predictor.predict({at(1.0), Pose2()}, {}, at(1.4));
  EXPECT_NEAR(motion.twist.linear, 0.2, 1e-9);
  EXPECT_NEAR(motion.T_map_base.x, 0.5 * 0.2 * 0.2 + 0.2 * 0.2, 0.003);
}

TEST(MotionPredictor, TakesEachCommandFromItsMomentOn) {
  RobotLimits quick = limits();
  quick.max_angular_acc = 1000.0;
  navigation::MotionPredictor agile(quick);
  agile.commanded({0.0, 1.0}, at(1.0));
  agile.commanded({0.0, 0.0}, at(1.2));
  EXPECT_NEAR(agile.predict({at(1.0), Pose2()}, {}, at(1.5)).T_map_base.yaw, 0.2, 0.001);
}

TEST(MotionPredictor, ForgetsWhatWasToldBeforeTheClockWasSetBack) {
  navigation::MotionPredictor predictor(limits());
  predictor.commanded({0.2, 0.0}, at(100.0));
  predictor.commanded({0.0, 0.0}, at(1.0));
  EXPECT_EQ(predictor.predict({at(1.0), Pose2()}, {}, at(1.4)).T_map_base.x, 0.0);
}

// [NAV-1] A navigator that stops for a cancelled goal tells its predictor so.
TEST(MotionPredictor, KnowsAfterACancelledGoalThatTheRobotStands_NAV_1) {
  OccupancyGrid floor(GridGeometry{0.05, Vec2::Zero(), 120, 60}, kFree);
  test::DrivenRobot robot(floor, {1.0, 1.5, 0.0});
  robot.send({5.0, 1.5}, 1);
  robot.run(2.0);
  ASSERT_GT(robot.speed(), 0.1);
  robot.cancel();
  robot.run(1.0);
  ASSERT_EQ(robot.speed(), 0.0);
  robot.pose_ahead = fromSeconds(-0.4);  // where the robot is now has to be predicted
  robot.send({5.0, 1.5}, 2);
  robot.tick();
  ASSERT_FALSE(robot.navigator().prediction().empty());
  EXPECT_LT((robot.navigator().prediction().front() - robot.pose().position()).norm(), 0.03);
}

}  // namespace
}  // namespace frontier_pilot
