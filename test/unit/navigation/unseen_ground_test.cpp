// What the scanner of a robot does not look at.

#include <gtest/gtest.h>

#include "support/floors/driven_robot.h"
#include "support/shipped_robot.h"

namespace frontier_pilot {
namespace {

using test::DrivenRobot;

/// A room of 6 m x 3 m.
OccupancyGrid room() {
  OccupancyGrid map(GridGeometry{0.05, Vec2::Zero(), 124, 64}, kOccupied);
  for (int y = 2; y < 62; ++y) {
    for (int x = 2; x < 122; ++x) map[Cell{x, y}] = kFree;
  }
  return map;
}

/// A robot whose scanner looks no farther to the sides than straight across.
navigation::NavigatorParams lookingAhead(const char* kind) {
  navigation::NavigatorParams params;
  params.robot = test::shippedRobot(kind);
  params.robot.scanner.field_of_view = kPi;
  params.robot.scanner.angle_min = -0.5 * kPi;
  return params;
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
    while (robot.recoveries.count("backing up") == 0) {
      robot.held = true;
      robot.tick();
    }
    robot.held = false;
    while (robot.output().recovery == "backing up") robot.tick();
    EXPECT_EQ(robot.contacts(), 0) << kind;
  }
}

}  // namespace
}  // namespace frontier_pilot
