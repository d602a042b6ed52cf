#include "frontier_pilot/patrol/patrol.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/kinematic_base.h"

namespace frontier_pilot {
namespace {

constexpr PatrolOrder kSquare{1.0, 1.0, 1.0};

/// A patrol, a base without noise, and the loop around them.
class Loop {
 public:
  explicit Loop(double frequency = 20.0, const Pose2& start = {}) : base(start), patrol(parameters(frequency)) {
    period_ = 1.0 / frequency;
  }
  static PatrolParameters parameters(double frequency) {
    PatrolParameters p;
    p.frequency = frequency;
    return p;
  }
  PatrolOutput start(const PatrolOrder& goal) { return patrol.start(goal, base.now()); }
  /// One cycle; `wheels`, if given, replaces the patrol's command on its way to the base.
  PatrolOutput cycle(const std::optional<Twist2>& wheels = std::nullopt) {
    if (fresh_odometry) inputs.odometry = base.sample();
    const PatrolOutput output = patrol.update(inputs, base.now());
    if (output.started_leg) legs.push_back(*output.started_leg);
    if (output.command) fastest.linear = std::max(fastest.linear, output.command->linear);
    if (output.command) fastest.angular = std::max(fastest.angular, output.command->angular);
    base.run(wheels ? *wheels : output.command.value_or(Twist2()), period_);
    return output;
  }
  /// Cycles until the patrol ends or `seconds` have passed.
  PatrolOutput run(double seconds, const std::optional<Twist2>& wheels = std::nullopt) {
    PatrolOutput output;
    const Time limit = base.now() + fromSeconds(seconds);
    do output = cycle(wheels);
    while (patrol.active() && base.now() < limit);
    return output;
  }

  test::KinematicBase base;
  Patrol patrol;
  PatrolInputs inputs;
  bool fresh_odometry = true;
  std::vector<int> legs;
  Twist2 fastest;

 private:
  double period_;
};

void expectEnd(const PatrolOutput& output, PatrolOutcome outcome) {
  EXPECT_EQ(output.outcome, outcome) << toString(output.outcome) << ": " << output.text;
  ASSERT_TRUE(output.command.has_value());
  EXPECT_TRUE(output.command->isZero());
}

void expectClosed(const Loop& loop, const Pose2& start) {
  EXPECT_LT((loop.base.pose().position() - start.position()).norm(), 0.02);
  EXPECT_NEAR(angleDifference(loop.base.pose().yaw, start.yaw), 0.0, kPi / 180.0);
}

// [PAT-2]
TEST(Patrol, EveryShapeClosesWithinTwoCentimetresAndOneDegree) {
  const Pose2 start(3.0, -2.0, 2.5);
  for (const double mode : {1.0, 2.0, 3.0}) {
    for (const double size : {0.3, 1.0, 2.5}) {
      for (const double frequency : {10.0, 15.0, 20.0}) {
        Loop loop(frequency, start);
        loop.start({mode, size, 2.0});
        expectEnd(loop.run(600.0), PatrolOutcome::kCompleted);
        SCOPED_TRACE(::testing::Message() << "mode " << mode << " size " << size << " at " << frequency << " Hz");
        expectClosed(loop, start);
        EXPECT_TRUE(loop.base.twist().isZero());
      }
    }
  }
}

// [PAT-2]
TEST(Patrol, TheSquareHasItsFourCornersOnTheLeft) {
  Loop loop;
  loop.start(kSquare);
  double left = 0.0, right = 0.0, front = 0.0;
  do {
    loop.cycle();
    left = std::max(left, loop.base.pose().y);
    right = std::min(right, loop.base.pose().y);
    front = std::max(front, loop.base.pose().x);
  } while (loop.patrol.active());
  EXPECT_NEAR(left, 1.0, 0.02);
  EXPECT_NEAR(front, 1.0, 0.02);
  EXPECT_NEAR(right, 0.0, 0.02);
}

// [PAT-2]
TEST(Patrol, SpeedsRiseAndFallNoFasterThanTheProfileAllows) {
  Loop loop;
  const PatrolParameters p;
  loop.start(kSquare);
  Twist2 last;
  while (loop.patrol.active()) {
    const PatrolOutput output = loop.cycle();
    const Twist2 command = output.command.value_or(Twist2());
    // The end of a leg is the exception: from the smallest speed to zero.
    EXPECT_LE(command.linear - last.linear, p.linear_acc * 0.05 + p.min_linear_speed);
    EXPECT_GE(command.linear - last.linear, -p.linear_acc * 0.05 - p.min_linear_speed);
    if (command.linear == 0.0 && last.linear == 0.0) {
      EXPECT_LE(std::abs(command.angular - last.angular), p.turn_acc * 0.05 + p.min_turn_speed);
    }
    last = command;
  }
  EXPECT_NEAR(loop.fastest.linear, p.linear_speed, 1e-9);
  EXPECT_NEAR(loop.fastest.angular, p.turn_speed, 1e-9);
}

// [PAT-2]
TEST(Patrol, ATargetThatIsOvershotEndsTheTurnInsteadOfAnotherRevolution) {
  Loop loop;
  loop.start(kSquare);
  while (loop.base.twist().angular < 0.5) loop.cycle();
  double turned = 0.0;
  // Someone else swings the robot past the corner.
  for (int i = 0; i < 12; ++i) loop.cycle(Twist2{0.0, 2.5});
  while (loop.legs.size() < 2) {
    const double before = loop.base.pose().yaw;
    loop.cycle();
    turned += angleDifference(loop.base.pose().yaw, before);
  }
  EXPECT_LT(std::abs(turned), 1.0);
}

// [PAT-3]
TEST(Patrol, EachLegIsAnnouncedOnceWhenItStarts) {
  Loop square;
  square.start({1.0, 0.4, 2.0});
  EXPECT_EQ(square.run(300.0).text, "square patrol complete!!");
  EXPECT_EQ(square.legs, (std::vector<int>{1, 2, 3, 4, 5, 6, 7, 8}));
  Loop triangle;
  triangle.start({2.0, 0.4, 1.0});
  EXPECT_EQ(triangle.run(300.0).text, "triangle patrol complete!!");
  EXPECT_EQ(triangle.legs, (std::vector<int>{1, 2, 3}));
  Loop circle;
  circle.start({3.0, 0.4, 3.0});
  EXPECT_EQ(circle.run(300.0).text, "circle patrol complete!!");
  EXPECT_EQ(circle.legs, (std::vector<int>{1, 2, 3}));
}

// [PAT-1]
TEST(Patrol, ABadGoalEndsBeforeAnyMotion) {
  Loop loop;
  const PatrolOutput output = loop.start({7.0, 1.0, 1.0});
  expectEnd(output, PatrolOutcome::kInvalidGoal);
  EXPECT_EQ(output.text, "invalid patrol mode");
  EXPECT_FALSE(loop.patrol.active());
}

// [PAT-4]
TEST(Patrol, CancelEndsItAtOnceInEveryPhase) {
  for (int cycles = 0; cycles < 400; cycles += 3) {
    Loop loop;
    loop.start({1.0, 0.3, 1.0});
    for (int i = 0; i < cycles && loop.patrol.active(); ++i) loop.cycle();
    if (!loop.patrol.active()) break;
    const PatrolOutput output = loop.patrol.cancel();
    expectEnd(output, PatrolOutcome::kCanceled);
    EXPECT_EQ(output.text, "patrol canceled");
    EXPECT_FALSE(loop.cycle().command.has_value());
  }
}

// [PAT-4]
TEST(Patrol, OdometryThatStopsEndsItAfterHalfASecond) {
  Loop loop;
  loop.start(kSquare);
  loop.run(2.0);
  loop.fresh_odometry = false;
  const Time silent = loop.base.now();
  const PatrolOutput output = loop.run(5.0);
  expectEnd(output, PatrolOutcome::kNoOdometry);
  EXPECT_EQ(output.text, "aborted: no odometry for 0.5 s");
  EXPECT_NEAR(toSeconds(loop.base.now() - silent), 0.6, 0.06);
}

// [PAT-4]
TEST(Patrol, WithoutAnyOdometryItNeverMoves) {
  Loop loop;
  loop.fresh_odometry = false;
  loop.start(kSquare);
  expectEnd(loop.run(5.0), PatrolOutcome::kNoOdometry);
  EXPECT_EQ(loop.fastest, Twist2());
}

// [PAT-4]
TEST(Patrol, AJumpOfOdometryEndsIt) {
  for (const Pose2& jump : {Pose2(0.0, 0.6, 0.0), Pose2(0.0, 0.0, 2.0)}) {
    Loop loop;
    loop.start(kSquare);
    loop.run(2.0);
    loop.base.teleport(loop.base.pose() * jump);
    expectEnd(loop.cycle(), PatrolOutcome::kOdometryJump);
  }
}

// [PAT-4]
TEST(Patrol, ABadQuaternionEndsItWithItsText) {
  Loop loop;
  loop.start(kSquare);
  loop.run(2.0);
  loop.inputs.odometry_problem = "quaternion of length 0";
  const PatrolOutput output = loop.cycle();
  expectEnd(output, PatrolOutcome::kBadOdometry);
  EXPECT_EQ(output.text, "aborted: bad odometry: quaternion of length 0");
}

TEST(Patrol, AClockThatJumpsBackEndsIt) {
  Loop loop;
  loop.start(kSquare);
  loop.run(2.0);
  expectEnd(loop.patrol.update(loop.inputs, loop.base.now() - fromSeconds(1.0)), PatrolOutcome::kClockJump);
}

// [PAT-4]
TEST(Patrol, ANewGoalAfterACancelledOneBeginsFromZeroWhereTheRobotIs) {
  Loop loop;
  loop.start(kSquare);
  loop.run(3.0);
  EXPECT_TRUE(loop.patrol.cancel().command->isZero());
  EXPECT_TRUE(loop.start({2.0, 0.5, 1.0}).command->isZero());
  const Pose2 start = loop.base.pose();
  const PatrolOutput output = loop.run(300.0);
  EXPECT_EQ(output.text, "triangle patrol complete!!");
  EXPECT_LT((loop.base.pose().position() - start.position()).norm(), 0.05);
}

// [PAT-5]
TEST(Patrol, WhatAnotherSourceDrivesIsCountedByOdometry) {
  Loop loop;
  loop.start(kSquare);
  loop.run(2.0);
  // Someone else drives the rest of the leg and a bit of it back again.
  loop.inputs.wheels_held_by = "avoid";
  loop.run(2.0, Twist2{0.15, 0.0});
  loop.run(1.0, Twist2{-0.1, 0.0});
  loop.inputs.wheels_held_by.reset();
  const PatrolOutput output = loop.run(300.0);
  EXPECT_EQ(output.text, "square patrol complete!!");
  expectClosed(loop, Pose2());
}

// [PAT-5]
TEST(Patrol, PushedAsideItComesBackToItsLeg) {
  Loop loop;
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
  Loop loop;
  loop.start(kSquare);
  loop.run(2.0);
  loop.inputs.wheels_held_by = "avoid";
  const Time held = loop.base.now();
  // Even if the holder happens to drive along the leg.
  const PatrolOutput output = loop.run(60.0, Twist2{0.02, 0.0});
  expectEnd(output, PatrolOutcome::kBlocked);
  EXPECT_EQ(output.text, "aborted: blocked for 10 s: avoid holds the wheels");
  EXPECT_NEAR(toSeconds(loop.base.now() - held), 10.05, 0.051);
}

// [PAT-5]
TEST(Patrol, WheelsThatDoNotTurnCountAsBlockedWhoeverHoldsThem) {
  Loop loop;
  loop.start(kSquare);
  const PatrolOutput output = loop.run(60.0, Twist2());
  expectEnd(output, PatrolOutcome::kBlocked);
  EXPECT_EQ(output.text, "aborted: blocked for 10 s: no progress");
}

// [PAT-5]
TEST(Patrol, GivingWayAgainAndAgainWithoutComingOnIsBlockedToo) {
  Loop loop;
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
  Loop loop;
  loop.start(kSquare);
  loop.run(2.0);
  loop.inputs.emergency_stop = true;
  const PatrolOutput output = loop.cycle();
  expectEnd(output, PatrolOutcome::kEmergencyStop);
  EXPECT_EQ(output.text, "aborted: emergency stop");
  loop.inputs.emergency_stop = false;
  for (int i = 0; i < 100; ++i) EXPECT_FALSE(loop.cycle().command.has_value());
}

// [PAT-6]
TEST(Patrol, WithoutAGoalItSaysNothing) {
  Loop loop;
  EXPECT_FALSE(loop.cycle().command.has_value());
  EXPECT_FALSE(loop.patrol.cancel().command.has_value());
  loop.start({1.0, 0.2, 1.0});
  loop.run(100.0);
  EXPECT_FALSE(loop.cycle().command.has_value());
}

TEST(PatrolParameters, AMinimumAboveTheSpeedIsRefused) {
  PatrolParameters p;
  EXPECT_EQ(loadParameters(parseYaml("{linear_speed: 0.01, min_turn_speed: 5.0}"), p).size(), 2U);
  EXPECT_TRUE(loadParameters(parseYaml("linear_speed: 0.1"), p).size() <= 1U);
}

}  // namespace
}  // namespace frontier_pilot
