// A robot that is no disc on its way: it gets through where its outline fits, and touches nothing.

#include <gtest/gtest.h>

#include "support/floors/driven_robot.h"
#include "support/floors/zigzag.h"
#include "support/shipped_robot.h"

namespace frontier_pilot {
namespace {

navigation::NavigatorParams forWaffle() {
  navigation::NavigatorParams params;
  params.robot = test::shippedRobot("waffle");
  return params;
}

// [ROB-1] [NAV-2]
TEST(OutlineNavigation, DrivesThroughTurnsInCorridorsThatOnlyTheOutlineFits) {
  // The circle around a Waffle is 0.51 m wide, and wants 0.045 m of room on either side on this map.
  for (const int width : {10, 11, 12}) {
    const double middle = 0.5 + 0.025 * width;
    test::DrivenRobot robot(test::zigzag(width), {0.8, middle, 0.0}, forWaffle());
    robot.send({5.4, 3.0 - 0.025 * width});
    const auto finished = robot.runUntilFinished(120.0);
    ASSERT_TRUE(finished) << width;
    EXPECT_EQ(finished->result, navigation::NavResult::kSucceeded) << width << ": " << toString(finished->reason);
    EXPECT_EQ(robot.contacts(), 0) << width;
  }
}

// [ROB-1] [NAV-1] [NAV-2]
TEST(OutlineNavigation, TurnsIntoTheGoalsDirectionOnlyWhereTheOutlineFits) {
  test::DrivenRobot roomy(test::zigzag(20), {0.8, 1.0, 0.0}, forWaffle());
  roomy.sendPose({2.0, 1.0, 0.5 * kPi}, true);
  const auto turned = roomy.runUntilFinished(60.0);
  ASSERT_TRUE(turned);
  EXPECT_EQ(turned->result, navigation::NavResult::kSucceeded);
  EXPECT_EQ(roomy.contacts(), 0);

  test::DrivenRobot narrow(test::zigzag(8), {0.8, 0.7, 0.0}, forWaffle());
  narrow.sendPose({2.0, 0.7, 0.5 * kPi}, true);
  const auto blocked = narrow.runUntilFinished(120.0);
  ASSERT_TRUE(blocked);
  EXPECT_EQ(blocked->result, navigation::NavResult::kAborted);
  EXPECT_EQ(narrow.contacts(), 0);
}

// [ROB-1] [NAV-3] A goal behind a robot that cannot turn where it stands.
TEST(OutlineNavigation, TouchesNothingWhereItCannotTurn) {
  test::DrivenRobot robot(test::zigzag(8), {2.0, 0.7, 0.0}, forWaffle());
  robot.send({0.8, 0.7});
  EXPECT_TRUE(robot.runUntilFinished(120.0));
  EXPECT_EQ(robot.contacts(), 0);
}

/// A room, and a dead end of `length` cells of 5 cm, 40 cm wide, that leads out of it along x.
OccupancyGrid deadEnd(int length) {
  OccupancyGrid map(GridGeometry{0.05, Vec2::Zero(), 40 + length, 40}, kOccupied);
  for (int y = 2; y < 38; ++y) {
    for (int x = 2; x < 32 + length; ++x) {
      if (x < 32 || (y >= 16 && y < 24)) map[Cell{x, y}] = kFree;
    }
  }
  return map;
}

// [ROB-1] [NAV-3] It can turn in the room only, and comes into the dead end at an angle.
TEST(OutlineNavigation, BacksOutOfADeadEndAlongTheWayThatItCame) {
  for (const int length : {12, 24, 36}) {
    test::DrivenRobot robot(deadEnd(length), {0.6, 0.6, 0.5}, forWaffle());
    robot.send({1.4 + 0.05 * length, 1.0});
    ASSERT_TRUE(robot.runUntilFinished(60.0));
    ASSERT_GT(robot.pose().x, 1.2 + 0.05 * length);
    robot.send({0.6, 1.4}, 2);
    const auto finished = robot.runUntilFinished(120.0);
    ASSERT_TRUE(finished) << length;
    EXPECT_EQ(finished->result, navigation::NavResult::kSucceeded) << length << ": " << toString(finished->reason);
    EXPECT_EQ(robot.contacts(), 0) << length;
  }
}

// [NAV-1] The search for a path that leaves room to turn may take long, and the base does what it was told last.
TEST(OutlineNavigation, BrakesBeforeASearchThatMayTakeLong_NAV_1) {
  test::DrivenRobot robot(test::zigzag(10), {0.8, 0.75, 0.0}, forWaffle());
  robot.send({2.2, 0.75});
  robot.run(2.0);
  ASSERT_GT(robot.speed(), 0.1);
  robot.send({5.4, 2.75}, 2);
  EXPECT_EQ(robot.tick().command, Twist2{});
  EXPECT_TRUE(robot.navigator().hasGoal());
  EXPECT_TRUE(robot.navigator().wayAhead().empty()) << "it has not planned yet";
  robot.tick();
  EXPECT_FALSE(robot.navigator().wayAhead().empty());
  const auto finished = robot.runUntilFinished(120.0);
  ASSERT_TRUE(finished);
  EXPECT_EQ(finished->result, navigation::NavResult::kSucceeded) << toString(finished->reason);
  EXPECT_EQ(robot.contacts(), 0);
}

}  // namespace
}  // namespace frontier_pilot
