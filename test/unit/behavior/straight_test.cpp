#include <gtest/gtest.h>

#include <limits>

#include "behavior_loop.h"
#include "support/shipped_robot.h"

namespace frontier_pilot {
namespace {

using test::BehaviorLoop;

behavior::BehaviorGoal backUp(double distance, double speed = 0.0, double allowance = 0.0) {
  return {behavior::BehaviorKind::kBackUp, distance, speed, allowance, true};
}
behavior::BehaviorGoal drive(double distance, double speed = 0.0) {
  return {behavior::BehaviorKind::kDriveOnHeading, distance, speed, 0.0, true};
}
behavior::BehaviorGoal wait(double time, double allowance = 0.0) {
  return {behavior::BehaviorKind::kWait, time, 0.0, allowance, true};
}

/// A wall across the x axis.
std::vector<Vec2> wallAt(double x) {
  std::vector<Vec2> points;
  for (double y = -0.6; y <= 0.6; y += 0.01) points.emplace_back(x, y);
  return points;
}

void expectOutcome(const behavior::BehaviorOutput& output, behavior::BehaviorOutcome outcome) {
  EXPECT_EQ(output.outcome, outcome) << toString(output.outcome) << ": " << output.message;
  ASSERT_TRUE(output.command.has_value());
  EXPECT_TRUE(output.command->isZero());
}

// [SPN-5]
TEST(Straight, BacksUpAndDrivesItsDistanceAndStands) {
  for (const double distance : {0.05, 0.15, 0.3, 0.8}) {
    for (const double speed : {0.0, 0.05, 0.2}) {
      BehaviorLoop back;
      back.start(backUp(distance, speed));
      const behavior::BehaviorOutput backed = back.run(60.0);
      expectOutcome(backed, behavior::BehaviorOutcome::kSucceeded);
      EXPECT_NEAR(back.base.pose().x, -distance, 0.01);
      EXPECT_NEAR(backed.progress, distance, 0.01);
      for (const double sign : {1.0, -1.0}) {
        BehaviorLoop ahead;
        ahead.start(drive(sign * distance, speed));
        expectOutcome(ahead.run(60.0), behavior::BehaviorOutcome::kSucceeded);
        EXPECT_NEAR(ahead.base.pose().x, sign * distance, 0.01);
      }
    }
  }
}

// [SPN-5]
TEST(Straight, NoFasterThanAskedAndThanAllowed) {
  BehaviorLoop slow;
  slow.start(drive(0.5, 0.05));
  for (int i = 0; i < 30; ++i) EXPECT_LE(slow.cycle().command->linear, 0.05);
  BehaviorLoop fast;
  fast.start(drive(0.5, 9.0));
  for (int i = 0; i < 10; ++i) EXPECT_LE(fast.cycle().command->linear, RobotLimits().max_linear);
}

// [SPN-5] [ROB-1] It looks 1.3 m ahead, by scans that may be half a second old.
TEST(Straight, AFastRobotIsNotRefusedWhereItSeesThatTheGroundIsFree_SPN_5_ROB_1) {
  behavior::BehaviorParameters parameters = BehaviorLoop::parameters(10.0);
  parameters.robot = test::shippedRobot("turtlebot2");
  BehaviorLoop loop(10.0, parameters.robot.limits);
  loop.behavior = behavior::TimedBehavior(parameters);
  loop.surroundings = behavior::CollisionCheck({}, parameters.robot);
  loop.surroundings.setReach(parameters.reach());
  loop.start(drive(8.0, parameters.robot.limits.max_linear));
  behavior::BehaviorOutput output;
  double fastest = 0.0;
  for (int i = 0; i < 300 && loop.behavior.active(); ++i) {
    loop.scanning = i % 5 == 0;
    output = loop.cycle();
    fastest = std::max(fastest, output.command->linear);
  }
  expectOutcome(output, behavior::BehaviorOutcome::kSucceeded);
  EXPECT_NEAR(loop.base.pose().x, 8.0, 0.05);
  EXPECT_NEAR(fastest, 0.65, 1e-9);
}

// [SPN-5]
TEST(Straight, StopsBeforeAWallWithoutTouchingIt) {
  BehaviorLoop back;
  back.points = wallAt(-0.45);
  back.start(backUp(1.0));
  const behavior::BehaviorOutput output = back.run(60.0);
  expectOutcome(output, behavior::BehaviorOutcome::kCollisionAhead);
  back.rest();
  EXPECT_LT(back.base.pose().x, -0.05);
  EXPECT_GT(back.base.pose().x - 0.101, -0.45);
  BehaviorLoop ahead;
  ahead.points = wallAt(0.1);
  ahead.start(drive(0.2));
  expectOutcome(ahead.cycle(), behavior::BehaviorOutcome::kCollisionAhead);
  EXPECT_FALSE(ahead.moved);
}

// [SPN-5]
TEST(Straight, ARobotThatTouchesSomethingMayBackAwayFromItButNotTurnOrDriveIntoIt) {
  const std::vector<Vec2> touching = wallAt(0.045);
  BehaviorLoop back;
  back.points = touching;
  back.start(backUp(0.2));
  expectOutcome(back.run(20.0), behavior::BehaviorOutcome::kSucceeded);
  BehaviorLoop ahead;
  ahead.points = touching;
  ahead.start(drive(0.2));
  expectOutcome(ahead.cycle(), behavior::BehaviorOutcome::kCollisionAhead);
  BehaviorLoop turn;
  turn.points = touching;
  turn.start({behavior::BehaviorKind::kSpin, 1.0, 0.0, 0.0, true});
  expectOutcome(turn.cycle(), behavior::BehaviorOutcome::kCollisionAhead);
}

// [SPN-5]
TEST(Straight, TimeoutsLostPosesAndStandstillsEndIt) {
  BehaviorLoop late;
  late.start(backUp(1.0, 0.1, 1.0));
  expectOutcome(late.run(20.0), behavior::BehaviorOutcome::kTimeout);
  BehaviorLoop lost;
  lost.start(backUp(1.0));
  lost.run(0.5);
  lost.posing = false;
  expectOutcome(lost.run(20.0), behavior::BehaviorOutcome::kPoseLost);
  BehaviorLoop stuck;
  stuck.start(backUp(1.0));
  expectOutcome(stuck.run(20.0, Twist2()), behavior::BehaviorOutcome::kNoProgress);
}

// [SPN-5]
TEST(Straight, BadGoalsAndZeroDistanceEndWithoutMotion) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  for (const behavior::BehaviorGoal& goal : {backUp(-0.1), backUp(kNan), backUp(0.1, -0.1), backUp(0.1, kNan),
                                             backUp(0.1, 0.1, -1.0), drive(kNan), wait(-1.0), wait(kNan)}) {
    BehaviorLoop loop;
    expectOutcome(loop.start(goal), behavior::BehaviorOutcome::kInvalidGoal);
  }
  for (const behavior::BehaviorGoal& goal : {backUp(0.0), drive(0.0), wait(0.0)}) {
    BehaviorLoop loop;
    expectOutcome(loop.start(goal), behavior::BehaviorOutcome::kSucceeded);
  }
}

// [SPN-5]
TEST(Straight, CancelTellsTheDistanceDone) {
  BehaviorLoop loop;
  loop.start(backUp(0.5));
  const behavior::BehaviorOutput last = loop.run(2.0);
  const behavior::BehaviorOutput output = loop.behavior.cancel("canceled", loop.base.now());
  expectOutcome(output, behavior::BehaviorOutcome::kCanceled);
  EXPECT_EQ(output.progress, last.progress);
  EXPECT_GT(output.progress, 0.1);
}

// [SPN-5]
TEST(Wait, CountsRosTimeAndNeedsNeitherPoseNorCostmap) {
  BehaviorLoop loop;
  loop.posing = loop.scanning = false;
  loop.start(wait(3.0));
  const Time since = loop.base.now();
  const behavior::BehaviorOutput output = loop.run(20.0);
  expectOutcome(output, behavior::BehaviorOutcome::kSucceeded);
  EXPECT_NEAR(toSeconds(loop.base.now() - since), 3.1, 1e-6);
  EXPECT_FALSE(loop.moved);
  EXPECT_NEAR(output.progress, 3.0, 1e-9);
}

// [SPN-5]
TEST(Wait, EndsByAllowanceCancelAndABackwardClock) {
  BehaviorLoop late;
  late.start(wait(3.0, 1.0));
  expectOutcome(late.run(20.0), behavior::BehaviorOutcome::kTimeout);
  BehaviorLoop canceled;
  canceled.start(wait(3.0));
  canceled.run(1.0);
  expectOutcome(canceled.behavior.cancel("canceled", canceled.base.now()), behavior::BehaviorOutcome::kCanceled);
  BehaviorLoop back;
  back.start(wait(3.0));
  back.run(1.0);
  EXPECT_EQ(back.behavior.update({}, back.base.now() - fromSeconds(0.5)).outcome, behavior::BehaviorOutcome::kPoseLost);
}

// [ROB-1] [SPN-5]
TEST(Behaviors, AreNoFasterThanTheRobot_ROB_1) {
  behavior::BehaviorParameters parameters = BehaviorLoop::parameters(10.0);
  parameters.robot.limits.max_linear = 0.04;
  parameters.robot.limits.max_angular = 0.2;
  BehaviorLoop loop;
  loop.behavior = behavior::TimedBehavior(parameters);
  loop.start(drive(0.5, 9.0));
  for (int i = 0; i < 10; ++i) EXPECT_LE(loop.cycle().command->linear, 0.04);
  loop.behavior.cancel("enough", loop.base.now());
  loop.rest();
  loop.start({behavior::BehaviorKind::kSpin, 1.0, 0.0, 0.0, true});
  for (int i = 0; i < 10; ++i) EXPECT_LE(loop.cycle().command->angular, 0.2);
}

// [ROB-1]
TEST(Behaviors, NameWhereTheLimitsHaveGone_ROB_1) {
  behavior::BehaviorParameters parameters;
  EXPECT_EQ(loadParameters(parseYaml("{rotational_acc_lim: 3.0, max_linear_vel: 0.2}"), parameters),
            (Problems{"rotational_acc_lim: is called robot/limits/max_angular_acc now",
                      "max_linear_vel: is called robot/limits/max_linear now"}));
}

// A step of the robot would be lost in the rounding of such a number, and standing would count as progress. [FLT-1]
TEST(Straight, RefusesTargetsThatNoRobotReaches_FLT_1) {
  EXPECT_TRUE(problemOf(drive(1e15)).has_value());
  EXPECT_TRUE(problemOf(backUp(1e5)).has_value());
  EXPECT_TRUE(problemOf(behavior::BehaviorGoal{behavior::BehaviorKind::kSpin, -1e300, 0.0, 0.0, true}).has_value());
  EXPECT_FALSE(problemOf(drive(-9999.0)).has_value());
  EXPECT_FALSE(problemOf(wait(1e6)).has_value());
}

}  // namespace
}  // namespace frontier_pilot
