#include "patrol/step_driver.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/kinematic_base.h"

namespace frontier_pilot {
namespace {

using Kind = patrol::PatrolStep::Kind;

patrol::PatrolStep step(Kind kind, double amount, double radius = 0.0) {
  patrol::PatrolStep step;
  step.kind = kind;
  step.amount = amount;
  step.radius = radius;
  return step;
}

MotionSample at(const Pose2& T_odom_base, const Twist2& twist = {}) { return {Time(), T_odom_base, twist}; }

class StepDriverTest : public ::testing::Test {
 protected:
  patrol::StepDriver driver{patrol::PatrolParameters()};
  patrol::PatrolParameters limits;
};

TEST_F(StepDriverTest, MeasuresALineAlongItsDirectionAlone) {
  const Pose2 T_odom_plan(3.0, -1.0, 2.0);
  driver.begin(step(Kind::kLine, 1.0), T_odom_plan, at(T_odom_plan));
  EXPECT_NEAR(driver.progress(), 0.0, 1e-12);
  driver.observe(at(T_odom_plan * Pose2(0.4, 0.3, 0.5)));
  EXPECT_NEAR(driver.progress(), 0.4, 1e-12);
  EXPECT_FALSE(driver.reached());
  driver.observe(at(T_odom_plan * Pose2(1.0, 0.3, 0.5)));
  EXPECT_TRUE(driver.reached());
}

TEST_F(StepDriverTest, CountsTurnsBeyondHalfARevolution) {
  driver.begin(step(Kind::kArc, 4.0 * kPi, 1.0), Pose2(), at(Pose2()));
  for (int i = 1; i <= 40; ++i) {
    driver.observe(at(Pose2(0.0, 0.0, normalizeAngle(0.1 * kPi * i))));
    ASSERT_NEAR(driver.progress(), 0.1 * kPi * i, 1e-9);
    ASSERT_EQ(driver.reached(), i == 40);
  }
}

TEST_F(StepDriverTest, MakesTheErrorOfTheStepBeforeGoodInThisOne) {
  driver.begin(step(Kind::kLine, 1.0), Pose2(), at(Pose2(-0.02, 0.0, 0.0)));
  EXPECT_NEAR(driver.progress(), -0.02, 1e-12) << "the step before ended too early";
  driver.begin(step(Kind::kTurn, 1.0), Pose2(), at(Pose2(0.0, 0.0, 0.05)));
  EXPECT_NEAR(driver.progress(), 0.05, 1e-12) << "the robot has turned too far already";
}

// [FLT-1] The inverse of a radius this small is infinite.
TEST_F(StepDriverTest, DrivesAnArcOfHardlyAnyRadiusWithFiniteSpeeds_FLT_1) {
  driver.begin(step(Kind::kArc, 2.0 * kPi, 1e-310), Pose2(), at(Pose2()));
  for (int i = 0; i < 20; ++i) {
    const Twist2 twist = driver.command(0.05, 0.0);
    ASSERT_TRUE(std::isfinite(twist.linear) && std::isfinite(twist.angular)) << i;
    EXPECT_LE(std::abs(twist.angular), limits.turn_speed);
  }
}

TEST_F(StepDriverTest, HasReachedAStepOfNoLengthAtOnce) {
  driver.begin(step(Kind::kLine, 0.0), Pose2(), at(Pose2()));
  EXPECT_TRUE(driver.reached());
}

TEST_F(StepDriverTest, StopsWhereTheNextCycleWouldBeFartherFromTheTarget) {
  const double half_a_cycle = 0.5 * 0.18 / limits.frequency;
  driver.begin(step(Kind::kLine, 1.0), Pose2(), at(Pose2()));
  driver.observe(at(Pose2(1.0 - 1.01 * half_a_cycle, 0.0, 0.0), {0.18, 0.0}));
  EXPECT_FALSE(driver.reached());
  driver.observe(at(Pose2(1.0 - 0.99 * half_a_cycle, 0.0, 0.0), {0.18, 0.0}));
  EXPECT_TRUE(driver.reached());
  driver.observe(at(Pose2(1.0 - 0.99 * half_a_cycle, 0.0, 0.0), {-0.18, 0.0}));
  EXPECT_FALSE(driver.reached()) << "a robot that rolls back comes no nearer by itself";
}

TEST_F(StepDriverTest, BeginsTheProfileFromStandingAndAgainAfterARest) {
  driver.begin(step(Kind::kLine, 5.0), Pose2(), at(Pose2()));
  EXPECT_NEAR(driver.command(0.1, 0.0).linear, 0.1 * limits.linear_acc, 1e-12);
  EXPECT_NEAR(driver.command(0.1, 0.0).linear, 0.2 * limits.linear_acc, 1e-12);
  for (int i = 0; i < 100; ++i) ASSERT_LE(driver.command(0.1, 0.0).linear, limits.linear_speed);
  driver.rest();
  EXPECT_NEAR(driver.command(0.1, 0.0).linear, 0.1 * limits.linear_acc, 1e-12);
}

TEST_F(StepDriverTest, BrakesEarlierTheOlderOdometryIs) {
  const auto speedBefore = [&](double age) {
    driver.begin(step(Kind::kLine, 1.0), Pose2(), at(Pose2(0.97, 0.0, 0.0)));
    return driver.command(10.0, age).linear;
  };
  EXPECT_LT(speedBefore(0.0), limits.linear_speed);
  EXPECT_LT(speedBefore(0.3), speedBefore(0.0));
  EXPECT_GE(speedBefore(100.0), limits.min_linear_speed) << "it still arrives";
}

TEST_F(StepDriverTest, SteersBackToTheLegFromEitherSide) {
  driver.begin(step(Kind::kLine, 5.0), Pose2(), at(Pose2(1.0, 0.1, 0.0)));
  EXPECT_LT(driver.command(0.1, 0.0).angular, 0.0);
  driver.begin(step(Kind::kLine, 5.0), Pose2(), at(Pose2(1.0, -0.1, 0.0)));
  EXPECT_GT(driver.command(0.1, 0.0).angular, 0.0);
  driver.begin(step(Kind::kLine, 5.0), Pose2(), at(Pose2(1.0, 0.0, 0.0)));
  EXPECT_EQ(driver.command(0.1, 0.0).angular, 0.0);
}

TEST_F(StepDriverTest, TurnsOnTheSpotFirstWhereItLooksTheWrongWay) {
  driver.begin(step(Kind::kLine, 5.0), Pose2(), at(Pose2(1.0, 0.0, kPi - 0.1)));
  const Twist2 command = driver.command(0.1, 0.0);
  EXPECT_EQ(command.linear, 0.0);
  EXPECT_LT(command.angular, 0.0) << "the shorter way round";
  EXPECT_GE(command.angular, -limits.turn_speed);
}

TEST_F(StepDriverTest, DrivesAnArcWithTheCurvatureOfItsCircle) {
  for (const double radius : {0.05, 0.3, 2.0}) {
    driver.begin(step(Kind::kArc, 2.0 * kPi, radius), Pose2(), at(Pose2()));
    Twist2 command;
    for (int i = 0; i < 100; ++i) command = driver.command(0.1, 0.0);
    EXPECT_NEAR(command.angular * radius, command.linear, 1e-9);
    EXPECT_LE(command.linear, limits.linear_speed + 1e-12);
    EXPECT_LE(command.angular, limits.turn_speed + 1e-12);
  }
}

TEST_F(StepDriverTest, BringsABaseToTheEndOfEveryKindOfStep) {
  const patrol::PatrolStep line = step(Kind::kLine, 0.7);
  const patrol::PatrolStep turn = step(Kind::kTurn, 2.0);
  const patrol::PatrolStep arc = step(Kind::kArc, 3.0, 0.4);
  for (const patrol::PatrolStep& asked : {line, turn, arc}) {
    const Pose2 start(1.0, 2.0, 3.0);
    test::KinematicBase base(start);
    driver.begin(asked, start, base.sample());
    int cycles = 0;
    while (!driver.reached() && ++cycles < 1000) {
      base.run(driver.command(0.05, 0.0), 0.05);
      driver.observe(base.sample());
    }
    EXPECT_NEAR(driver.progress(), asked.amount, 0.01);
  }
}

}  // namespace
}  // namespace frontier_pilot
