// What the scanner of a robot does not look at: ground that it never saw, and what it has seen and turned its back to.

#include <gtest/gtest.h>

#include <optional>

#include "support/floors/driven_robot.h"
#include "support/floors/room.h"
#include "support/shipped_robot.h"

namespace frontier_pilot {
namespace {

using test::DrivenRobot;
using test::room;

constexpr int kMostTicks = 2000;  // what has not come by then will not come

/// The room with a wall in column `x`.
void drawWall(OccupancyGrid& map, int x) {
  for (int y = 2; y < 62; ++y) map[Cell{x, y}] = kOccupied;
}

/// A robot whose scanner looks no farther to the sides than straight across.
navigation::NavigatorParams lookingAhead(const char* kind) {
  navigation::NavigatorParams params;
  params.robot = test::shippedRobot(kind);
  params.robot.scanner.field_of_view = kPi;
  params.robot.scanner.angle_min = -0.5 * kPi;
  return params;
}

/// What a scanner that looks ahead from `x` has not seen.
void hideBehind(OccupancyGrid& map, double x) {
  for (int row = 0; row < map.height(); ++row) {
    for (int column = 0; map.geometry().centre(Cell{column, row}).x() < x; ++column) map[Cell{column, row}] = kUnknown;
  }
}

// [NAV-3] [NAV-4] The way ahead is blocked, and neither the map nor the scanner shows the wall behind the robot.
TEST(RecoveriesWithAScannerThatLooksAhead, DoNotBackIntoAWallThatNothingShows_NAV_3_NAV_4) {
  for (const char* kind : {"burger", "turtlebot2", "waffle"}) {
    const navigation::NavigatorParams params = lookingAhead(kind);
    const double x = 2.34 + params.robot.drivenOutline().rear();
    OccupancyGrid world = room(), map = room();
    drawWall(world, 64);
    drawWall(world, 45);  // its surface is at x = 2.3
    hideBehind(map, x + params.robot.scanner.x);
    DrivenRobot robot(world, {x, 1.55, 0.0}, params);
    robot.navigator().setMap(map, map.geometry().rect());
    robot.send({5.0, 1.55});
    EXPECT_TRUE(robot.runUntilFinished(300.0)) << kind;
    EXPECT_EQ(robot.recoveries.count("backing up"), 1U) << kind;
    EXPECT_EQ(robot.contacts(), 0) << kind;
  }
}

// [NAV-3] [NAV-4]
TEST(RecoveriesWithAScannerThatLooksAhead, BackUpOverUnseenGroundAsFarAsTheRobotStoodOnIt_NAV_3_NAV_4) {
  for (const char* kind : {"burger", "waffle"}) {
    navigation::NavigatorParams params = lookingAhead(kind);
    OccupancyGrid map = room();
    hideBehind(map, 2.2);
    DrivenRobot robot(room(), {2.0, 1.5, 0.0}, params);
    robot.navigator().setMap(map, map.geometry().rect());
    std::optional<bool> to_the_start, beyond_the_start;
    const auto look = [&](const navigation::RecoveryInputs& in, Time) {
      to_the_start = in.has_room({2.0, 1.5, 0.0});
      beyond_the_start = in.has_room({1.97, 1.5, 0.0});
      return navigation::RecoveryStep{{}, true};
    };
    robot.navigator().setParameters(params, {{"looking", false, [&] { return look; }}});
    robot.send({5.0, 1.5});
    for (int i = 0; i < kMostTicks && robot.pose().x < 2.5; ++i) robot.tick();
    ASSERT_GE(robot.pose().x, 2.5) << kind;
    robot.held = true;
    robot.runUntilFinished(60.0);
    ASSERT_TRUE(to_the_start) << kind;
    EXPECT_TRUE(*to_the_start) << kind;
    EXPECT_FALSE(*beyond_the_start) << kind;
  }
}

// [NAV-3] [NAV-4] What the robot has turned its back to cannot be marked again.
TEST(RecoveriesWithAScannerThatLooksAhead, DoNotBackIntoACrateThatTheRobotHasTurnedItsBackTo_NAV_3_NAV_4) {
  for (const char* kind : {"burger", "turtlebot2", "waffle"}) {
    const navigation::NavigatorParams params = lookingAhead(kind);
    const double rear = params.robot.drivenOutline().rear();
    DrivenRobot robot(room(), {3.0, 1.5, kPi}, params);
    ASSERT_EQ(robot.simulator().spawnObstacle("crate", {3.0 - rear - 0.08 - 0.2, 1.5, 0.0}, 0.2),
              sim::Placement::kDone);
    robot.run(1.0);
    ASSERT_EQ(robot.simulator().setPose("", {3.0, 1.5, 0.0}), sim::Placement::kDone);
    robot.run(1.5);
    robot.send({5.0, 1.5});
    for (int i = 0; i < kMostTicks && robot.recoveries.count("backing up") == 0; ++i) {
      robot.held = true;
      robot.tick();
    }
    ASSERT_GT(robot.recoveries.count("backing up"), 0U) << kind;
    robot.held = false;
    for (int i = 0; i < kMostTicks && robot.output().recovery == "backing up"; ++i) robot.tick();
    ASSERT_NE(robot.output().recovery, "backing up") << kind;
    EXPECT_EQ(robot.contacts(), 0) << kind;
  }
}

}  // namespace
}  // namespace frontier_pilot
