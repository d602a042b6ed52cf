#include "patrol_loop.h"

namespace frontier_pilot {
namespace {

using test::expectClosed;
using test::expectEnd;
using test::kSquare;
using test::PatrolLoop;

// [PAT-4]
TEST(Patrol, CancelEndsItAtOnceInEveryPhase) {
  for (int cycles = 0; cycles < 400; cycles += 3) {
    PatrolLoop loop;
    loop.start({1.0, 0.3, 1.0});
    for (int i = 0; i < cycles && loop.patrol.active(); ++i) loop.cycle();
    if (!loop.patrol.active()) break;
    const patrol::PatrolOutput output = loop.patrol.cancel();
    expectEnd(output, patrol::PatrolOutcome::kCanceled);
    EXPECT_EQ(output.text, "patrol canceled");
    EXPECT_FALSE(loop.cycle().command.has_value());
  }
}

// [PAT-4]
TEST(Patrol, OdometryThatStopsEndsItAfterHalfASecond) {
  PatrolLoop loop;
  loop.start(kSquare);
  loop.run(2.0);
  loop.fresh_odometry = false;
  const Time silent = loop.base.now();
  const patrol::PatrolOutput output = loop.run(5.0);
  expectEnd(output, patrol::PatrolOutcome::kNoOdometry);
  EXPECT_EQ(output.text, "aborted: no odometry for 0.5 s");
  EXPECT_NEAR(toSeconds(loop.base.now() - silent), 0.6, 0.06);
}

// [PAT-4]
TEST(Patrol, WithoutAnyOdometryItNeverMoves) {
  PatrolLoop loop;
  loop.fresh_odometry = false;
  loop.start(kSquare);
  expectEnd(loop.run(5.0), patrol::PatrolOutcome::kNoOdometry);
  EXPECT_EQ(loop.fastest, Twist2());
}

// [PAT-4]
TEST(Patrol, AJumpOfOdometryEndsIt) {
  for (const Pose2& jump : {Pose2(0.0, 0.6, 0.0), Pose2(0.0, 0.0, 2.0)}) {
    PatrolLoop loop;
    loop.start(kSquare);
    loop.run(2.0);
    loop.base.teleport(loop.base.pose() * jump);
    expectEnd(loop.cycle(), patrol::PatrolOutcome::kOdometryJump);
  }
}

// [PAT-4]
TEST(Patrol, ABadQuaternionEndsItWithItsText) {
  PatrolLoop loop;
  loop.start(kSquare);
  loop.run(2.0);
  loop.inputs.odometry_problem = "quaternion of length 0";
  const patrol::PatrolOutput output = loop.cycle();
  expectEnd(output, patrol::PatrolOutcome::kBadOdometry);
  EXPECT_EQ(output.text, "aborted: bad odometry: quaternion of length 0");
}

TEST(Patrol, AClockThatJumpsBackEndsIt) {
  PatrolLoop loop;
  loop.start(kSquare);
  loop.run(2.0);
  expectEnd(loop.patrol.update(loop.inputs, loop.base.now() - fromSeconds(1.0)), patrol::PatrolOutcome::kClockJump);
}

// [PAT-4]
TEST(Patrol, ANewGoalAfterACancelledOneBeginsFromZeroWhereTheRobotIs) {
  PatrolLoop loop;
  loop.start(kSquare);
  loop.run(3.0);
  EXPECT_TRUE(loop.patrol.cancel().command->isZero());
  EXPECT_TRUE(loop.start({2.0, 0.5, 1.0}).command->isZero());
  const Pose2 start = loop.base.pose();
  const patrol::PatrolOutput output = loop.run(300.0);
  EXPECT_EQ(output.text, "triangle patrol complete!!");
  EXPECT_LT((loop.base.pose().position() - start.position()).norm(), 0.05);
}

// [PAT-5]
TEST(Patrol, WhatAnotherSourceDrivesIsCountedByOdometry) {
  PatrolLoop loop;
  loop.start(kSquare);
  loop.run(2.0);
  // Someone else drives the rest of the leg and a bit of it back again.
  loop.inputs.wheels_held_by = "avoid";
  loop.run(2.0, Twist2{0.15, 0.0});
  loop.run(1.0, Twist2{-0.1, 0.0});
  loop.inputs.wheels_held_by.reset();
  const patrol::PatrolOutput output = loop.run(300.0);
  EXPECT_EQ(output.text, "square patrol complete!!");
  expectClosed(loop, Pose2());
}

// [PAT-5]
TEST(Patrol, PushedAsideItComesBackToItsLeg) {
  PatrolLoop loop;
  loop.start({1.0, 2.0, 1.0});
  loop.run(3.0);
  loop.inputs.wheels_held_by = "avoid";
  loop.run(0.8, Twist2{0.0, 1.5});
  loop.run(1.0, Twist2{0.2, 0.0});
  loop.inputs.wheels_held_by.reset();
  EXPECT_GT(loop.base.pose().y, 0.1);
  while (loop.patrol.active() && loop.base.pose().x < 1.9) loop.cycle();
  EXPECT_NEAR(loop.base.pose().y, 0.0, 0.02);
  loop.run(300.0);
  expectClosed(loop, Pose2());
}

// [PAT-5]
TEST(Patrol, HeldForTheBlockedTimeoutItGivesUpAndNamesWhoHoldsTheWheels) {
  PatrolLoop loop;
  loop.start(kSquare);
  loop.run(2.0);
  loop.inputs.wheels_held_by = "avoid";
  const Time held = loop.base.now();
  // Even if the holder happens to drive along the leg.
  const patrol::PatrolOutput output = loop.run(60.0, Twist2{0.02, 0.0});
  expectEnd(output, patrol::PatrolOutcome::kBlocked);
  EXPECT_EQ(output.text, "aborted: blocked for 10 s: avoid holds the wheels");
  EXPECT_NEAR(toSeconds(loop.base.now() - held), 10.05, 0.051);
}

// [PAT-5]
TEST(Patrol, WheelsThatDoNotTurnCountAsBlockedWhoeverHoldsThem) {
  PatrolLoop loop;
  loop.start(kSquare);
  const patrol::PatrolOutput output = loop.run(60.0, Twist2());
  expectEnd(output, patrol::PatrolOutcome::kBlocked);
  EXPECT_EQ(output.text, "aborted: blocked for 10 s: no progress");
}

// [PAT-5]
TEST(Patrol, GivingWayAgainAndAgainWithoutComingOnIsBlockedToo) {
  PatrolLoop loop;
  loop.start(kSquare);
  loop.run(3.0);
  for (int i = 0; i < 30 && loop.patrol.active(); ++i) {
    loop.inputs.wheels_held_by = "avoid";
    loop.run(0.4, Twist2{-0.22, 0.0});
    loop.inputs.wheels_held_by.reset();
    loop.run(0.4);
  }
  EXPECT_FALSE(loop.patrol.active());
}

// [PAT-5]
TEST(Patrol, AnEmergencyStopEndsItForGood) {
  PatrolLoop loop;
  loop.start(kSquare);
  loop.run(2.0);
  loop.inputs.emergency_stop = true;
  const patrol::PatrolOutput output = loop.cycle();
  expectEnd(output, patrol::PatrolOutcome::kEmergencyStop);
  EXPECT_EQ(output.text, "aborted: emergency stop");
  loop.inputs.emergency_stop = false;
  for (int i = 0; i < 100; ++i) EXPECT_FALSE(loop.cycle().command.has_value());
}

// [FLT-1] No time is before that of a goal which came before the first /clock.
TEST(Patrol, AClockThatJumpsEndsItAlsoWhenItBeganAtTimeZero) {
  PatrolLoop loop;
  loop.patrol.start(kSquare, Time{});
  const patrol::PatrolOutput output = loop.patrol.abortByClockJump();
  expectEnd(output, patrol::PatrolOutcome::kClockJump);
  EXPECT_EQ(output.text, "aborted: the clock jumped");
  EXPECT_STREQ(toString(output.outcome), "the clock jumped");
}

// [PAT-6]
TEST(Patrol, WithoutAGoalItSaysNothing) {
  PatrolLoop loop;
  EXPECT_FALSE(loop.patrol.abortByClockJump().command.has_value());
  EXPECT_FALSE(loop.cycle().command.has_value());
  EXPECT_FALSE(loop.patrol.cancel().command.has_value());
  loop.start({1.0, 0.2, 1.0});
  loop.run(100.0);
  EXPECT_FALSE(loop.cycle().command.has_value());
}

}  // namespace
}  // namespace frontier_pilot
