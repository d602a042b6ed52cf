#include "navigation/motion_predictor.h"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace frontier_pilot
