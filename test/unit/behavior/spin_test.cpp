#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "behavior/sweep.h"
#include "behavior_loop.h"

namespace frontier_pilot {
namespace {

using behavior::BehaviorGoal;
using behavior::BehaviorKind;
using behavior::BehaviorOutcome;
using behavior::BehaviorOutput;
using test::BehaviorLoop;

BehaviorGoal spin(double angle, double allowance = 0.0) { return {BehaviorKind::kSpin, angle, 0.0, allowance, true}; }

void expectEnd(const BehaviorOutput& output, BehaviorOutcome outcome) {
  EXPECT_EQ(output.outcome, outcome) << toString(output.outcome) << ": " << output.message;
  ASSERT_TRUE(output.command.has_value());
  EXPECT_TRUE(output.command->isZero());
}

// [SPN-4]
TEST(Spin, EndsWithinFiveHundredthsOfTheTargetForAnyAngleAndAnyBaseThatCanFollow) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> angle(-2.0 * kPi, 2.0 * kPi);
  for (const double acceleration : {2.5, 3.2, 6.0, 50.0}) {
    RobotLimits limits;
    limits.max_angular_acc = acceleration;
    for (int i = 0; i < 100; ++i) {
      BehaviorLoop loop(10.0, limits, {1.0, 2.0, angle(random)});
      loop.scanning = false;
      const double target = angle(random);
      TurnCounter turned;
      turned.restart(loop.base.pose().yaw);
      loop.start({BehaviorKind::kSpin, target, 0.0, 0.0, false});
      BehaviorOutput output;
      while (loop.behavior.active()) {
        output = loop.cycle();
        turned.add(loop.base.pose().yaw);
      }
      expectEnd(output, BehaviorOutcome::kSucceeded);
      loop.rest();
      turned.add(loop.base.pose().yaw);
      EXPECT_NEAR(turned.total(), target, 0.05) << "acceleration " << acceleration;
      EXPECT_NEAR(output.progress, turned.total(), 0.005);
    }
  }
}

// [SPN-1]
TEST(Spin, CountsSignedYawAcrossTheSeam) {
  for (const double target : {2.0, -2.0, 9.0, -9.0}) {
    BehaviorLoop loop(10.0, {}, {0.0, 0.0, target > 0.0 ? 3.0 : -3.0});
    loop.start(spin(target));
    const BehaviorOutput output = loop.run(60.0);
    EXPECT_EQ(output.outcome, BehaviorOutcome::kSucceeded);
    EXPECT_NEAR(output.progress, target, 0.05);
  }
}

// [SPN-1]
TEST(Spin, TheSpeedIsTheBrakingLawsBetweenItsBounds) {
  const behavior::BehaviorParameters p;
  BehaviorLoop loop;
  loop.start(spin(kPi));
  double slowest = 10.0, fastest = 0.0;
  while (loop.behavior.active()) {
    const double remaining = kPi - bearing(direction(loop.base.pose().yaw));
    const BehaviorOutput output = loop.cycle();
    const double speed = output.command->angular;
    if (speed == 0.0) continue;
    EXPECT_LE(speed, std::max(p.min_rotational_vel, std::sqrt(2.0 * RobotLimits().max_angular_acc * remaining)) + 1e-9);
    slowest = std::min(slowest, speed);
    fastest = std::max(fastest, speed);
  }
  EXPECT_DOUBLE_EQ(fastest, p.max_rotational_vel);
  EXPECT_GE(slowest, p.min_rotational_vel);
}

// [SPN-1]
TEST(Spin, TheFirstCycleFromStandingFollowsTheBrakingLawExactly) {
  for (const double target : {0.05, 0.1, 0.15, 0.3}) {
    BehaviorLoop loop;
    loop.start(spin(-target));
    EXPECT_DOUBLE_EQ(loop.cycle().command->angular, -std::clamp(std::sqrt(6.4 * target), 0.4, 1.0));
  }
}

// [SPN-1]
TEST(Spin, TheAllowanceComesBeforeEverythingElse) {
  BehaviorLoop loop;
  loop.start(spin(6.0, 1.0));
  loop.run(0.9);
  EXPECT_TRUE(loop.behavior.active());
  // Also the pose is gone and something is in the way: the allowance is what is told.
  loop.base.run({}, 1.0);
  loop.inputs.pose.reset();
  loop.posing = loop.scanning = false;
  expectEnd(loop.cycle(), BehaviorOutcome::kTimeout);
}

// [SPN-1]
TEST(Spin, AMissingOldOrBrokenPoseComesBeforeTheCostmap) {
  BehaviorLoop none;
  none.posing = none.scanning = false;
  none.start(spin(1.0));
  expectEnd(none.cycle(), BehaviorOutcome::kPoseLost);

  BehaviorLoop old;
  old.start(spin(3.0));
  old.run(0.5);
  old.posing = false;
  const Time since = old.base.now() - fromSeconds(0.1);
  expectEnd(old.run(5.0), BehaviorOutcome::kPoseLost);
  EXPECT_NEAR(toSeconds(old.base.now() - since), 0.7, 0.101);

  BehaviorLoop jump;
  jump.start(spin(3.0));
  jump.run(0.5);
  jump.base.teleport(jump.base.pose() * Pose2(1.0, 0.0, 0.0));
  const BehaviorOutput output = jump.cycle();
  expectEnd(output, BehaviorOutcome::kPoseLost);
  EXPECT_EQ(output.message, "the pose jumped");
}

/// Where the front left corner of the default footprint, padding included, comes along.
Vec2 frontCornerAt(double yaw) { return Pose2(0.0, 0.0, yaw) * Vec2(0.047, 0.099); }
/// The same for the rear left one, which reaches farthest; a little inside of it.
Vec2 rearCornerAt(double yaw) { return Pose2(0.0, 0.0, yaw) * Vec2(0.975 * Vec2(-0.111, 0.099)); }

// [SPN-1]
TEST(Spin, ATargetThatIsReachedComesBeforeWhatIsAhead) {
  for (const double target : {0.3, 3.0}) {
    BehaviorLoop loop;
    loop.start(spin(target));
    loop.cycle();
    loop.base.run({0.0, 1.0}, 0.7);
    loop.points = {rearCornerAt(loop.base.pose().yaw), rearCornerAt(loop.base.pose().yaw + 0.3)};
    expectEnd(loop.run(2.0), target < 1.0 ? BehaviorOutcome::kSucceeded : BehaviorOutcome::kCollisionAhead);
  }
}

// [SPN-2]
TEST(Spin, AnObstacleWhereTheFirstTenthOfASecondSweepsIsSeenBeforeAnythingMoves) {
  behavior::CollisionCheckParameters fine;
  fine.costmap.resolution = 0.005;
  fine.costmap.side = 1.0;
  // A tenth of a second turns by at most 0.1 rad. The front corner passes these points then, and nothing after it.
  for (const double yaw : {0.05, 0.07}) {
    BehaviorLoop loop;
    loop.surroundings = behavior::CollisionCheck(fine);
    loop.points = {frontCornerAt(yaw)};
    loop.start(spin(1.5));
    expectEnd(loop.cycle(), BehaviorOutcome::kCollisionAhead);
    EXPECT_FALSE(loop.moved);
    const behavior::CollisionCheck& seen = loop.surroundings;
    const auto turn = [&](double from, double to) {
      return behavior::sweep(seen.grid(), seen.footprint(), {0.0, 0.0, from},
                             {behavior::AxisMotion::Axis::kTurn, to - from});
    };
    EXPECT_EQ(turn(0.0, 0.0), behavior::SweepResult::kClear);
    EXPECT_EQ(turn(0.0, 0.1), behavior::SweepResult::kObstacle);
    EXPECT_EQ(turn(0.15, 1.5), behavior::SweepResult::kClear);
  }
}

// [SPN-2]
TEST(Spin, TheLookAheadReachesTheEndPoseAndNotBeyondTheTarget) {
  const double target = 0.6;
  BehaviorLoop at_end;
  at_end.points = {rearCornerAt(target)};
  at_end.start(spin(target));
  expectEnd(at_end.cycle(), BehaviorOutcome::kCollisionAhead);
  BehaviorLoop beyond;
  beyond.points = {rearCornerAt(target + 0.5)};
  beyond.start(spin(target));
  expectEnd(beyond.run(10.0), BehaviorOutcome::kSucceeded);
}

// [SPN-2]
TEST(Spin, TheLookAheadEndsAfterItsTimeAndRollsOnWithTheTurn) {
  // The right rear corner meets the point at 2.45 rad; 2 s at 1 rad/s see it when 0.45 rad are done.
  BehaviorLoop loop;
  loop.points = {rearCornerAt(3.9)};
  loop.start(spin(6.0));
  EXPECT_FALSE(loop.cycle().command->isZero());
  const BehaviorOutput output = loop.run(20.0);
  expectEnd(output, BehaviorOutcome::kCollisionAhead);
  EXPECT_GT(output.progress, 0.15);
  EXPECT_LT(output.progress, 0.55);
}

// [SPN-3]
TEST(Spin, AnObstacleThatAppearsStopsItInTheNextCycle) {
  BehaviorLoop loop;
  loop.start(spin(6.0));
  loop.run(1.0);
  EXPECT_FALSE(loop.cycle().command->isZero());
  loop.points = {rearCornerAt(loop.base.pose().yaw + 0.8)};
  const BehaviorOutput output = loop.cycle();
  expectEnd(output, BehaviorOutcome::kCollisionAhead);
  EXPECT_EQ(output.message, "not free ahead: an obstacle");
}

// [SPN-3]
TEST(Spin, WithoutAFreshCostmapNothingIsFree) {
  BehaviorLoop never;
  never.scanning = false;
  never.start(spin(1.0));
  const BehaviorOutput output = never.cycle();
  expectEnd(output, BehaviorOutcome::kCollisionAhead);
  EXPECT_EQ(output.message, "not free ahead: no fresh scan");

  BehaviorLoop old;
  old.start(spin(6.0));
  old.run(0.5);
  old.scanning = false;
  const Time since = old.base.now() - fromSeconds(0.1);
  expectEnd(old.run(5.0), BehaviorOutcome::kCollisionAhead);
  EXPECT_NEAR(toSeconds(old.base.now() - since), 0.7, 0.101);
}

// [SPN-3]
TEST(Spin, CollisionChecksCanBeSwitchedOff) {
  BehaviorLoop loop;
  loop.points = {frontCornerAt(0.1)};
  BehaviorGoal goal = spin(1.0);
  goal.check_collisions = false;
  loop.start(goal);
  expectEnd(loop.run(10.0), BehaviorOutcome::kSucceeded);
}

// [SPN-4]
TEST(Spin, BadGoalsEndWithoutMotion) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  constexpr double kEndless = std::numeric_limits<double>::infinity();
  for (const BehaviorGoal& goal : {spin(kNan), spin(kEndless), spin(1.0, -0.1), spin(1.0, kNan)}) {
    BehaviorLoop loop;
    expectEnd(loop.start(goal), BehaviorOutcome::kInvalidGoal);
    EXPECT_FALSE(loop.cycle().command.has_value());
  }
}

// [SPN-4]
TEST(Spin, AZeroTargetSucceedsMotionless) {
  BehaviorLoop loop;
  expectEnd(loop.start(spin(0.0)), BehaviorOutcome::kSucceeded);
  EXPECT_FALSE(loop.behavior.active());
}

// [SPN-4]
TEST(Spin, WithoutYawProgressForTwoSecondsItGivesUp) {
  BehaviorLoop loop;
  loop.start(spin(2.0));
  const Time since = loop.base.now();
  expectEnd(loop.run(10.0, Twist2()), BehaviorOutcome::kNoProgress);
  EXPECT_NEAR(toSeconds(loop.base.now() - since), 2.15, 0.1);
  BehaviorLoop midway;
  midway.start(spin(3.0));
  midway.run(1.0);
  expectEnd(midway.run(10.0, Twist2()), BehaviorOutcome::kNoProgress);
}

// [SPN-4]
TEST(Spin, AnEmergencyStopEndsItForGood) {
  BehaviorLoop loop;
  loop.start(spin(3.0));
  loop.run(0.5);
  loop.inputs.emergency_stop = true;
  const BehaviorOutput output = loop.cycle();
  expectEnd(output, BehaviorOutcome::kNoProgress);
  EXPECT_EQ(output.message, "emergency stop");
  loop.inputs.emergency_stop = false;
  EXPECT_FALSE(loop.cycle().command.has_value());
}

// [SPN-5]
TEST(Spin, CancelStopsAtOnceAndTellsTheAmountDone) {
  for (int cycles = 1; cycles < 60; ++cycles) {
    BehaviorLoop loop;
    loop.start(spin(-2.0));
    BehaviorOutput last;
    for (int i = 0; i < cycles && loop.behavior.active(); ++i) last = loop.cycle();
    if (!loop.behavior.active()) break;
    const BehaviorOutput output = loop.behavior.cancel("canceled", loop.base.now());
    expectEnd(output, BehaviorOutcome::kCanceled);
    EXPECT_EQ(output.progress, last.progress);
    EXPECT_NEAR(output.elapsed, 0.1 * cycles, 1e-6);
    EXPECT_FALSE(loop.cycle().command.has_value());
  }
}

}  // namespace
}  // namespace frontier_pilot
