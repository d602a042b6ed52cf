#include "planning/inflation_exit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include "support/ascii_world.h"
#include "support/floors/open_floor.h"

namespace frontier_pilot {
namespace {

using test::clearanceOf;
using test::drawWorld;

double distance(const planning::ClearanceMap& map, Cell a, Cell b) {
  return (map.geometry().centre(a) - map.geometry().centre(b)).norm();
}

/// A wall below a robot that touches it.
const auto kAtAWall = drawWorld(R"(
  ................
  ................
  ................
  ................
  ................
  ................
  ........S.......
  ################
)");

TEST(InflationExit, FromAPassableCellIsThatCell) {
  const planning::ClearanceMap map = clearanceOf(OccupancyGrid(GridGeometry{0.05, Vec2::Zero(), 20, 20}, kFree));
  for (const double radius : {0.0, 0.5}) {
    const std::vector<planning::InflationExit> escapes = planning::findInflationExits(map, {10, 10}, radius);
    ASSERT_EQ(escapes.size(), 1U);
    EXPECT_EQ(escapes[0].cells, (std::vector<Cell>{{10, 10}}));
    EXPECT_EQ(escapes[0].cost, 0.0);
  }
}

TEST(InflationExit, LeadsFromAWallToTheNearestPassableCellFirst) {
  const planning::ClearanceMap map = clearanceOf(kAtAWall.map);
  const Cell start = kAtAWall.cell('S');
  ASSERT_FALSE(map.isPassable(start));
  const std::vector<planning::InflationExit> escapes = planning::findInflationExits(map, start, 0.3);
  ASSERT_GT(escapes.size(), 1U);
  EXPECT_EQ(escapes[0].cells.back().x, start.x) << "straight away from the wall";
  double last = 0.0;
  for (const planning::InflationExit& escape : escapes) {
    EXPECT_GE(escape.cost, last) << "the cheapest first";
    last = escape.cost;
    EXPECT_EQ(escape.cells.front(), start);
    EXPECT_LE(distance(map, start, escape.cells.back()), 0.3 + 1e-9);
    for (std::size_t i = 0; i < escape.cells.size(); ++i) {
      EXPECT_EQ(map.isPassable(escape.cells[i]), i + 1 == escape.cells.size()) << "it ends where one may stand";
      if (i == 0) continue;
      const Cell a = escape.cells[i - 1];
      const Cell b = escape.cells[i];
      EXPECT_EQ(std::max(std::abs(a.x - b.x), std::abs(a.y - b.y)), 1);
    }
  }
}

TEST(InflationExit, IsNoneWhereNothingPassableIsNearEnough) {
  const planning::ClearanceMap map = clearanceOf(kAtAWall.map);
  EXPECT_TRUE(planning::findInflationExits(map, kAtAWall.cell('S'), 0.0).empty());
  EXPECT_TRUE(planning::findInflationExits(map, kAtAWall.cell('S'), 0.05).empty());
  const planning::ClearanceMap full = clearanceOf(OccupancyGrid(GridGeometry{0.05, Vec2::Zero(), 20, 20}, kOccupied));
  EXPECT_TRUE(planning::findInflationExits(full, {10, 10}, 1.0).empty());
  EXPECT_TRUE(planning::findInflationExits(clearanceOf(drawWorld("#").map), {0, 0}, 1.0).empty());
}

TEST(InflationExit, CrossesNoWallToARoomBeyond) {
  const auto world = drawWorld(R"(
    ....................
    ....................
    ....................
    ....................
    ####################
    ####################
    ####################
    ####################
    .........S..........
    ####################
    ####################
    ####################
  )");
  EXPECT_TRUE(planning::findInflationExits(clearanceOf(world.map), world.cell('S'), 0.5).empty())
      << "the walls reach farther than what lies under the robot";
}

TEST(InflationExit, TakesWhatLiesUnderTheRobotForNoise) {
  OccupancyGrid grid(GridGeometry{0.05, Vec2::Zero(), 30, 30}, kFree);
  for (int k = 0; k < 9; ++k) grid[Cell{14 + k % 3, 14 + k / 3}] = kOccupied;
  const planning::ClearanceMap map = clearanceOf(grid);
  ASSERT_TRUE(map.isOccupied({15, 15}));
  EXPECT_FALSE(planning::findInflationExits(map, {15, 15}, 0.5).empty());
}

TEST(InflationExit, LeadsOutOfTheUnknownAtTheEdgeOfTheMap) {
  const auto world = drawWorld(R"(
    ???.........
    ???.........
    ???.........
    ???.........
  )");
  const std::vector<planning::InflationExit> escapes =
      planning::findInflationExits(clearanceOf(world.map), {0, 0}, 0.5);
  ASSERT_FALSE(escapes.empty());
  EXPECT_EQ(escapes[0].cells.back(), (Cell{3, 0}));
}

TEST(InflationExit, GoesBeyondTheFirstPassableCellOnlyWhenAskedTo) {
  const planning::ClearanceMap map = clearanceOf(OccupancyGrid(GridGeometry{0.05, Vec2::Zero(), 21, 21}, kFree));
  const std::vector<planning::InflationExit> escapes = planning::findInflationExits(map, {10, 10}, 0.1, true);
  EXPECT_EQ(escapes.size(), 13U) << "every cell within two of it";
  EXPECT_EQ(escapes[0].cells.size(), 1U) << "the cell itself is the cheapest";
}

}  // namespace
}  // namespace frontier_pilot
