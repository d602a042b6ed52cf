#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "behavior/local_costmap.h"
#include "behavior/sweep.h"
#include "frontier_pilot/behavior/collision_check.h"
#include "support/ascii_world.h"
#include "support/shipped_robot.h"

namespace frontier_pilot {
namespace {

constexpr float kInf = std::numeric_limits<float>::infinity();

LaserScan2 scanOf(std::size_t beams, float range) {
  LaserScan2 scan;
  scan.stamp = timeFromSeconds(1.0);
  scan.angle_min = -kPi;
  scan.angle_increment = 2.0 * kPi / static_cast<double>(beams);
  scan.range_min = 0.1;
  scan.range_max = 3.5;
  scan.ranges.assign(beams, range);
  return scan;
}

std::int8_t at(const behavior::LocalCostmap& map, const Vec2& point) {
  return map.grid().get(map.grid().geometry().cellAt(point), 55);
}

Outline square(double half) { return Outline::polygon({{half, half}, {-half, half}, {-half, -half}, {half, -half}}); }

// [SPN-3]
TEST(LocalCostmap, WhatNoBeamCrossedIsUnknownWhatOneEndedInIsOccupied) {
  behavior::LocalCostmap map({}, square(0.1));
  EXPECT_TRUE(map.grid().empty());
  EXPECT_FALSE(map.stamp().has_value());
  map.insert(scanOf(1440, 1.01F), {});
  EXPECT_EQ(at(map, {0.5, 0.3}), kFree);
  EXPECT_EQ(at(map, {1.01, 0.0}), kOccupied);
  EXPECT_EQ(at(map, {-1.01, 0.0}), kOccupied);
  EXPECT_EQ(at(map, {1.2, 0.0}), kUnknown);
  EXPECT_EQ(map.stamp(), timeFromSeconds(1.0));
}

TEST(LocalCostmap, InvalidBeamsSayNothingAndTooNearOnesAreObstacles) {
  behavior::LocalCostmap map({}, square(0.05));
  map.insert(scanOf(1440, std::numeric_limits<float>::quiet_NaN()), {});
  EXPECT_EQ(at(map, {0.5, 0.0}), kUnknown);
  EXPECT_EQ(at(map, {0.0, 0.0}), kFree) << "the robot stands there";
  map.insert(scanOf(1440, 0.03F), {});
  EXPECT_EQ(at(map, {0.1, 0.0}), kOccupied);
  map.insert(scanOf(1440, kInf), {});
  EXPECT_EQ(at(map, {0.1, 0.0}), kFree);
  EXPECT_EQ(at(map, {1.4, 0.0}), kFree);
}

TEST(LocalCostmap, RollsWithTheRobotAndKeepsWhatItSaw) {
  behavior::LocalCostmap map({}, square(0.05));
  const LaserScan2 blind = scanOf(8, std::numeric_limits<float>::quiet_NaN());
  map.insert(scanOf(1440, 1.01F), {0.0, 0.0, 0.7});
  for (double x = 0.0; x <= 0.7; x += 0.013) map.insert(blind, {x, -0.5 * x, x});
  EXPECT_EQ(at(map, {1.01, 0.0}), kOccupied);
  EXPECT_EQ(at(map, {0.5, 0.3}), kFree);
  EXPECT_EQ(at(map, {2.1, 0.0}), kUnknown) << "the window has come here, nobody has looked";
  EXPECT_EQ(at(map, {-1.0, 0.0}), 55) << "the window has left";
  map.insert(blind, {50.0, 50.0, 0.0});
  EXPECT_EQ(at(map, {50.5, 50.0}), kUnknown);
}

TEST(LocalCostmap, TheScannersMountIsRespected) {
  LaserScan2 scan = scanOf(1440, kInf);
  scan.T_base_sensor = {0.2, 0.0, kPi};
  scan.ranges[720] = 0.615F;  // straight ahead of the sensor, which looks back
  behavior::LocalCostmap map({}, square(0.05));
  map.insert(scan, {1.01, 1.01, 0.5 * kPi});
  EXPECT_EQ(at(map, {1.01, 1.01 + 0.2 - 0.615}), kOccupied);
}

// [SCN-1]
TEST(LocalCostmap, PutsABeamWhereTheRobotWasWhenItWasMeasured_SCN_1) {
  LaserScan2 scan = scanOf(1440, kInf);
  scan.ranges[0] = 0.61F;
  const Vec2 now = scan.point(0, 0.61);
  scan.moving_mounts.assign(scan.ranges.size(), Pose2(-0.1, 0.0, -0.6));
  const Vec2 then = scan.point(0, 0.61);
  behavior::LocalCostmap map({}, square(0.05));
  map.insert(scan, {});
  EXPECT_EQ(at(map, then), kOccupied);
  EXPECT_EQ(at(map, now), kFree);
}

// [SPN-3]
TEST(Sweep, UnknownCellsTheEdgeOfTheGridAndNoGridAreNotFree) {
  const test::AsciiWorld world = test::drawWorld(R"(
    ....................
    ....................
    ....................
    ....................
    .........A..........
    ....................
    ..............?.....
    ....................
    ....................
  )");
  const Outline footprint = square(0.1);
  const Pose2 pose(world.point('A'), 0.0);
  const auto line = [](double amount) { return behavior::AxisMotion{behavior::AxisMotion::Axis::kLine, amount}; };
  EXPECT_EQ(behavior::sweep(world.map, footprint, pose, {behavior::AxisMotion::Axis::kTurn, 6.0}),
            behavior::SweepResult::kClear);
  EXPECT_EQ(behavior::sweep(world.map, footprint, pose, line(0.05)), behavior::SweepResult::kClear);
  EXPECT_EQ(behavior::sweep(world.map, footprint, pose, {behavior::AxisMotion::Axis::kTurn, 1e12}),
            behavior::SweepResult::kClear)
      << "of many turns one is looked at";
  EXPECT_EQ(behavior::sweep(world.map, footprint, pose, line(-1e12)), behavior::SweepResult::kOffGrid);
  EXPECT_EQ(behavior::sweep(world.map, footprint, pose, line(0.2)), behavior::SweepResult::kUnseen);
  EXPECT_EQ(behavior::sweep(world.map, footprint, pose, line(-0.6)), behavior::SweepResult::kOffGrid);
  OccupancyGrid walled = world.map;
  for (int row = 0; row < walled.geometry().height; ++row) walled[Cell{17, row}] = kOccupied;
  EXPECT_EQ(behavior::sweep(walled, footprint, pose, line(0.2)), behavior::SweepResult::kUnseen);
  EXPECT_EQ(behavior::sweep(walled, footprint, pose, line(0.4)), behavior::SweepResult::kObstacle);  // behind it
  EXPECT_EQ(behavior::sweep(OccupancyGrid(), footprint, pose, line(0.1)), behavior::SweepResult::kNoCostmap);
}

// [SPN-2]
TEST(Sweep, NoCellThatAFineSweepTouchesIsMissed) {
  GridGeometry geometry;
  geometry.resolution = 0.025;
  geometry.width = geometry.height = 40;
  const Outline footprint = behavior::CollisionCheck().footprint();
  const Pose2 pose(0.5, 0.5, 0.3);
  std::vector<Cell> cells;
  std::set<std::pair<int, int>> touched;
  for (int i = 0; i <= 2000; ++i) {
    footprint.cellsAt(pose * Pose2(0.0, 0.0, i * 1e-3), geometry, cells);
    for (const Cell c : cells) touched.insert({c.x, c.y});
  }
  int missed = 0;
  for (const auto& [x, y] : touched) {
    OccupancyGrid grid(geometry, kFree);
    grid[Cell{x, y}] = kOccupied;
    if (behavior::sweep(grid, footprint, pose, {behavior::AxisMotion::Axis::kTurn, 2.0}) ==
        behavior::SweepResult::kClear)
      ++missed;
  }
  // Between two poses a corner may graze less than half a cell's depth of a cell that neither touches.
  EXPECT_LE(missed, static_cast<int>(touched.size()) / 50);
}

// [SPN-3] What was free when the scanner still looked there may be free no more.
TEST(CollisionCheck, BlocksEveryMotionOnceTheScansNoLongerShowWhatIsAhead) {
  behavior::CollisionCheck check;
  LaserScan2 scan = scanOf(1440, 2.0F);
  EXPECT_TRUE(check.insert(scan, {}));
  EXPECT_TRUE(check.lookAhead(0.5, scan.stamp));
  scan.stamp += std::chrono::seconds(1);
  scan.angle_min = 0.5 * kPi;
  scan.ranges.resize(720);
  EXPECT_FALSE(check.insert(scan, {}));
  EXPECT_FALSE(check.lookAhead(0.5, scan.stamp));
}

// [SPN-3] Between two behaviours, where no jump of the pose ends one.
TEST(CollisionCheck, ForgetsWhatItSawWhenOdometryHasBeenReset) {
  for (const Pose2& jumped : {Pose2(1.0, 0.0, 0.0), Pose2(0.0, 0.0, kPi)}) {
    behavior::CollisionCheck check;
    LaserScan2 scan = scanOf(1440, 1.3F);
    check.insert(scan, {});
    const auto at = [&](const Vec2& point) { return check.grid().get(check.grid().geometry().cellAt(point), 55); };
    ASSERT_EQ(at({-0.4, 0.0}), kFree);
    scan.stamp += std::chrono::milliseconds(200);
    scan.ranges.assign(1440, std::numeric_limits<float>::quiet_NaN());
    std::fill_n(scan.ranges.begin() + 590, 260, 0.2F);  // ahead
    ASSERT_TRUE(check.insert(scan, {0.1, 0.0, 0.1}));
    EXPECT_EQ(at({-0.4, 0.0}), kFree) << "it has driven on";
    scan.stamp += std::chrono::milliseconds(200);
    ASSERT_TRUE(check.insert(scan, jumped));
    EXPECT_EQ(at({0.5, 0.5}), kUnknown);
  }
}

// [ROB-1]
TEST(Footprint, IsTheRobotsExactOutlineWithThePaddingAroundIt) {
  const Outline burger = behavior::CollisionCheck().footprint();
  EXPECT_FALSE(burger.isDisc());
  EXPECT_NEAR(burger.halfWidth(), 0.099, 1e-9);
  EXPECT_NEAR(burger.front(), 0.047, 1e-9);
  EXPECT_NEAR(burger.circumscribedRadius(), std::hypot(0.111, 0.099), 1e-9);
  behavior::CollisionCheckParameters parameters;
  parameters.footprint.padding = 0.05;
  const Outline waffle = behavior::CollisionCheck(parameters, test::shippedRobot("waffle")).footprint();
  EXPECT_NEAR(waffle.halfWidth(), 0.203, 1e-9);
  EXPECT_NEAR(waffle.front(), 0.127, 1e-9);
  EXPECT_NEAR(waffle.circumscribedRadius(), std::hypot(0.255, 0.203), 1e-9);
}

// [ROB-1]
TEST(Footprint, NamesWhereThePolygonHasGone) {
  behavior::CollisionCheckParameters parameters;
  EXPECT_EQ(loadParameters(parseYaml("footprint: {polygon: [0.1, 0.1, -0.1, 0.1, 0.0, -0.1]}"), parameters),
            (Problems{"footprint/polygon: is called robot/outline now"}));
}

}  // namespace
}  // namespace frontier_pilot
