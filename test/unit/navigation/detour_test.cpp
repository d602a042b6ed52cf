// Doors that are shut, though the map shows them open.

#include <gtest/gtest.h>

#include <cmath>
#include <optional>

#include "support/floors/driven_robot.h"
#include "support/shipped_robot.h"

namespace frontier_pilot {
namespace {

using navigation::NavResult;
using test::DrivenRobot;

/// Two corridors of 14 m x 1 m, one beside the other, and joined at both ends unless these passages are shut.
OccupancyGrid loop(bool left_is_open, bool right_is_open) {
  OccupancyGrid map(GridGeometry{0.05, Vec2::Zero(), 284, 64}, kOccupied);
  const auto clear = [&](const CellRect& cells) {
    for (int y = cells.y; y < cells.y + cells.height; ++y) {
      for (int x = cells.x; x < cells.x + cells.width; ++x) map[Cell{x, y}] = kFree;
    }
  };
  clear({2, 2, 280, 20});
  clear({2, 42, 280, 20});
  if (left_is_open) clear({2, 22, 20, 20});
  if (right_is_open) clear({262, 22, 20, 20});
  return map;
}

std::optional<navigation::NavFinished> finishedIn(const OccupancyGrid& world, double seconds) {
  const OccupancyGrid map = loop(true, true);
  DrivenRobot robot(world, {1.5, 0.6, 0.0});
  robot.navigator().setMap(map, map.geometry().rect());
  robot.send({1.5, 2.6});
  return robot.runUntilFinished(seconds);
}

// [NAV-1] The door is out of sight for longer than an obstacle is remembered, and the way back would be shorter.
TEST(Detours, AreDrivenToTheirEndAlsoWhereTheShutDoorIsLongOutOfSight_NAV_1) {
  const auto finished = finishedIn(loop(false, true), 400.0);
  ASSERT_TRUE(finished);
  EXPECT_EQ(finished->result, NavResult::kSucceeded);
}

// [NAV-1]
TEST(Detours, BetweenTwoShutDoorsComeToAnEnd_NAV_1) {
  const auto finished = finishedIn(loop(false, false), 3000.0);
  ASSERT_TRUE(finished);
  EXPECT_EQ(finished->result, NavResult::kAborted);
}

/// A hall of 8 m x 4 m, with a box of `size` [m] before the lower wall, or without it.
OccupancyGrid hall(const Vec2& size) {
  OccupancyGrid map(GridGeometry{0.05, Vec2::Zero(), 160, 80}, kOccupied);
  for (std::size_t i = 0; i < map.size(); ++i) {
    const Vec2 at = map.geometry().centre(map.geometry().cell(i));
    const bool inside = at.x() > 0.1 && at.x() < 7.9 && at.y() > 0.1 && at.y() < 3.9;
    const bool box = std::abs(at.x() - 4.0) < 0.5 * size.x() && std::abs(at.y() - 1.6) < 0.5 * size.y();
    if (inside && !box) map[i] = kFree;
  }
  return map;
}

// [NAV-1] [MUL-3] It could be a robot that sets off: the border with it must not be a wall.
TEST(Detours, LeadAlongBoxesThatTheMapLacks_NAV_1_MUL_3) {
  for (const double width : {0.4, 0.6, 0.8, 1.0, 1.15, 2.0}) {
    for (const char* kind : {"burger", "waffle", "turtlebot2"}) {
      navigation::NavigatorParams params;
      params.robot = test::shippedRobot(kind);
      DrivenRobot robot(hall({width, 0.4}), {1.0, 1.6, 0.0}, params);
      const OccupancyGrid map = hall(Vec2::Zero());
      robot.navigator().setMap(map, map.geometry().rect());
      robot.send({7.0, 1.6});
      const auto finished = robot.runUntilFinished(60.0);
      ASSERT_TRUE(finished) << kind << ", " << width << " m";
      EXPECT_EQ(finished->result, NavResult::kSucceeded) << kind << ", " << width << " m";
      const bool may_back_up = !params.robot.drivenOutline().isDisc();  // its corners swing out
      EXPECT_TRUE(may_back_up || robot.recoveries.empty()) << kind << ", " << width << " m";
      EXPECT_EQ(robot.simulator().contactCount(0), 0) << kind << ", " << width << " m";
    }
  }
}

}  // namespace
}  // namespace frontier_pilot
