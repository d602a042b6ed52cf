#include <gtest/gtest.h>

#include <limits>
#include <set>

#include "frontier_pilot/behavior/local_costmap.h"
#include "frontier_pilot/behavior/sweep.h"
#include "support/ascii_world.h"

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

std::int8_t at(const LocalCostmap& map, const Vec2& point) {
  return map.grid().get(map.grid().geometry().cellAt(point), 55);
}

Footprint square(double half) {
  FootprintParameters parameters;
  parameters.polygon = {half, half, -half, half, -half, -half, half, -half};
  parameters.padding = 0.0;
  return Footprint(parameters);
}

// [SPN-3]
TEST(LocalCostmap, WhatNoBeamCrossedIsUnknownWhatOneEndedInIsOccupied) {
  LocalCostmap map({}, square(0.1));
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
  LocalCostmap map({}, square(0.05));
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
  LocalCostmap map({}, square(0.05));
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
  LocalCostmap map({}, square(0.05));
  map.insert(scan, {1.01, 1.01, 0.5 * kPi});
  EXPECT_EQ(at(map, {1.01, 1.01 + 0.2 - 0.615}), kOccupied);
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
  const Footprint footprint = square(0.1);
  const Pose2 pose(world.point('A'), 0.0);
  const auto line = [](double amount) { return AxisMotion{AxisMotion::Axis::kLine, amount}; };
  EXPECT_EQ(sweep(world.map, footprint, pose, {AxisMotion::Axis::kTurn, 6.0}), SweepResult::kClear);
  EXPECT_EQ(sweep(world.map, footprint, pose, line(0.05)), SweepResult::kClear);
  EXPECT_EQ(sweep(world.map, footprint, pose, line(0.2)), SweepResult::kUnseen);
  EXPECT_EQ(sweep(world.map, footprint, pose, line(-0.6)), SweepResult::kOffGrid);
  EXPECT_EQ(sweep(OccupancyGrid(), footprint, pose, line(0.1)), SweepResult::kNoCostmap);
}

// [SPN-2]
TEST(Sweep, NoCellThatAFineSweepTouchesIsMissed) {
  GridGeometry geometry;
  geometry.resolution = 0.025;
  geometry.width = geometry.height = 40;
  const Footprint footprint((FootprintParameters()));
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
    if (sweep(grid, footprint, pose, {AxisMotion::Axis::kTurn, 2.0}) == SweepResult::kClear) ++missed;
  }
  // Between two poses a corner may graze less than half a cell's depth of a cell that neither touches.
  EXPECT_LE(missed, static_cast<int>(touched.size()) / 50);
}

TEST(Footprint, TakesEveryCellItTouchesAndNoOther) {
  GridGeometry geometry;
  geometry.resolution = 0.1;
  geometry.width = geometry.height = 20;
  std::vector<Cell> cells;
  square(0.25).cellsAt({1.05, 1.05, 0.0}, geometry, cells);
  std::set<std::pair<int, int>> unique;
  for (const Cell c : cells) unique.insert({c.x, c.y});
  EXPECT_EQ(unique.size(), 36U) << "0.8 to 1.3 m in cells of 0.1 m, with what the border touches";
}

TEST(Footprint, PaddingMovesEverySideOutAndTheRadiusWithIt) {
  FootprintParameters parameters;
  parameters.padding = 0.05;
  const Footprint footprint(parameters);
  double left = 0.0, front = 0.0;
  for (const Vec2& corner : footprint.corners()) {
    left = std::max(left, corner.y());
    front = std::max(front, corner.x());
  }
  EXPECT_NEAR(left, 0.139, 1e-9);
  EXPECT_NEAR(front, 0.087, 1e-9);
  EXPECT_NEAR(footprint.radius(), std::hypot(0.151, 0.139), 1e-9);
}

TEST(Footprint, APolygonWithoutAreaOrWithTheOriginOutsideIsRefused) {
  const auto problems = [](const std::string& yaml) {
    FootprintParameters parameters;
    return loadParameters(parseYaml(yaml), parameters).size();
  };
  EXPECT_EQ(problems("polygon: [0.1, 0.1, -0.1, 0.1, 0.0, -0.1]"), 0U);
  EXPECT_EQ(problems("polygon: [0.1, 0.1, -0.1, 0.1]"), 1U);
  EXPECT_EQ(problems("polygon: [0.1, 0.1, -0.1, 0.1, 0.0]"), 1U);
  EXPECT_EQ(problems("polygon: [0.1, 0.1, 0.2, 0.2, 0.3, 0.3]"), 1U);
  EXPECT_EQ(problems("polygon: [1.1, 1.1, 0.9, 1.1, 1.0, 0.9]"), 1U);
}

}  // namespace
}  // namespace frontier_pilot
