// Doors that are shut, though the map shows them open.

#include <gtest/gtest.h>

#include <cmath>
#include <optional>

#include "support/floors/driven_robot.h"

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

}  // namespace
}  // namespace frontier_pilot
