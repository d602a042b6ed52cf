#include "patrol_loop.h"

namespace frontier_pilot {
namespace {

using test::expectClosed;
using test::expectEnd;
using test::kSquare;
using test::PatrolLoop;

// [PAT-2]
TEST(Patrol, EveryShapeClosesWithinTwoCentimetresAndOneDegree) {
  const Pose2 start(3.0, -2.0, 2.5);
  for (const double mode : {1.0, 2.0, 3.0}) {
    for (const double size : {0.3, 1.0, 2.5}) {
      for (const double frequency : {10.0, 15.0, 20.0}) {
        PatrolLoop loop(frequency, start);
        loop.start({mode, size, 2.0});
        expectEnd(loop.run(600.0), patrol::PatrolOutcome::kCompleted);
        SCOPED_TRACE(::testing::Message() << "mode " << mode << " size " << size << " at " << frequency << " Hz");
        expectClosed(loop, start);
        EXPECT_TRUE(loop.base.twist().isZero());
      }
    }
  }
}

// [PAT-2]
TEST(Patrol, TheSquareHasItsFourCornersOnTheLeft) {
  PatrolLoop loop;
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
  PatrolLoop loop;
  const patrol::PatrolParameters p;
  loop.start(kSquare);
  Twist2 last;
  while (loop.patrol.active()) {
    const patrol::PatrolOutput output = loop.cycle();
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
  PatrolLoop loop;
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
  PatrolLoop square;
  square.start({1.0, 0.4, 2.0});
  EXPECT_EQ(square.run(300.0).text, "square patrol complete!!");
  EXPECT_EQ(square.legs, (std::vector<int>{1, 2, 3, 4, 5, 6, 7, 8}));
  PatrolLoop triangle;
  triangle.start({2.0, 0.4, 1.0});
  EXPECT_EQ(triangle.run(300.0).text, "triangle patrol complete!!");
  EXPECT_EQ(triangle.legs, (std::vector<int>{1, 2, 3}));
  PatrolLoop circle;
  circle.start({3.0, 0.4, 3.0});
  EXPECT_EQ(circle.run(300.0).text, "circle patrol complete!!");
  EXPECT_EQ(circle.legs, (std::vector<int>{1, 2, 3}));
}

// [PAT-1]
TEST(Patrol, ABadGoalEndsBeforeAnyMotion) {
  PatrolLoop loop;
  const patrol::PatrolOutput output = loop.start({7.0, 1.0, 1.0});
  expectEnd(output, patrol::PatrolOutcome::kInvalidGoal);
  EXPECT_EQ(output.text, "invalid patrol mode");
  EXPECT_FALSE(loop.patrol.active());
}

TEST(PatrolParameters, AMinimumAboveTheSpeedIsRefused) {
  patrol::PatrolParameters p;
  p.min_turn_speed = 5.0;
  EXPECT_EQ(loadParameters(parseYaml("{linear_speed: 0.01}"), p).size(), 2U);
  p = {};
  EXPECT_TRUE(loadParameters(parseYaml("linear_speed: 0.1"), p).size() <= 1U);
}

// [ROB-1]
TEST(PatrolParameters, AreCutToWhatTheRobotCanDo_ROB_1) {
  const patrol::PatrolParameters burger = patrol::withinLimits({});
  EXPECT_EQ(printRows(describeParameters(burger)), printRows(describeParameters(patrol::PatrolParameters())))
      << "a Burger can do all of it";
  patrol::PatrolParameters slow;
  slow.robot.limits = {0.015, 0.05, 0.2, 0.3};
  const patrol::PatrolParameters cut = patrol::withinLimits(slow);
  EXPECT_EQ(cut.linear_speed, 0.015);
  EXPECT_EQ(cut.min_linear_speed, 0.015);
  EXPECT_EQ(cut.turn_speed, 0.05);
  EXPECT_EQ(cut.min_turn_speed, 0.05);
  EXPECT_EQ(cut.linear_acc, 0.2);
  EXPECT_EQ(cut.turn_acc, 0.3);
}

TEST(Patrol, OtherSpeedsAndLimitsHoldFromTheNextCycleOn) {
  PatrolLoop loop;
  loop.start({1.0, 2.0, 1.0});
  loop.run(3.0);
  EXPECT_GT(loop.fastest.linear, 0.17);
  patrol::PatrolParameters slower = PatrolLoop::parameters(20.0);
  slower.robot.limits.max_linear = 0.1;
  slower.turn_speed = 0.5;
  loop.patrol.setParameters(slower);
  loop.fastest = {};
  expectEnd(loop.run(200.0), patrol::PatrolOutcome::kCompleted);
  EXPECT_LE(loop.fastest.linear, 0.1);
  EXPECT_LE(loop.fastest.angular, 0.5);
  expectClosed(loop, {});
}

}  // namespace
}  // namespace frontier_pilot
