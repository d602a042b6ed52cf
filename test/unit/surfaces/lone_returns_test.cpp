#include "surfaces/lone_returns.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace frontier_pilot {
namespace {

using Indices = std::vector<std::size_t>;

/// A wall at 2 m, seen by beams one degree apart.
LaserScan2 wallBefore() {
  LaserScan2 scan;
  scan.angle_min = -0.5;
  scan.angle_increment = kPi / 180.0;
  scan.range_min = 0.12;
  scan.range_max = 10.0;
  for (int i = 0; i < 58; ++i)
    scan.ranges.push_back(static_cast<float>(2.0 / std::cos(scan.angle(scan.ranges.size()))));
  return scan;
}

TEST(LoneReturns, MAP_1_LieFarBehindBothNeighbours) {
  LaserScan2 scan = wallBefore();
  EXPECT_EQ(surfaces::loneReturns(scan), Indices{});
  scan.ranges[30] = 6.0F;
  EXPECT_EQ(surfaces::loneReturns(scan), Indices{30});
  scan.ranges[30] = 2.3F;
  EXPECT_EQ(surfaces::loneReturns(scan), Indices{}) << "a dent in the wall";
}

TEST(LoneReturns, MAP_1_AreNotThoseOfADoorOrOfAPole) {
  LaserScan2 scan = wallBefore();
  scan.ranges[30] = scan.ranges[31] = 6.0F;
  EXPECT_EQ(surfaces::loneReturns(scan), Indices{}) << "two beams through one opening";
  scan = wallBefore();
  scan.ranges[30] = 1.0F;
  EXPECT_EQ(surfaces::loneReturns(scan), Indices{}) << "something before the wall";
  scan = wallBefore();
  for (const std::size_t beam : {20U, 22U, 24U, 26U}) scan.ranges[beam] = 6.0F;
  EXPECT_EQ(surfaces::loneReturns(scan), Indices{}) << "a wall behind bars";
}

TEST(LoneReturns, MAP_1_AreCountedAmongTheReturns) {
  LaserScan2 scan = wallBefore();
  scan.ranges[5] = std::nanf("");
  scan.ranges[29] = 0.0F;
  scan.ranges[30] = 6.0F;
  EXPECT_EQ(surfaces::loneReturns(scan), Indices{28});
  scan.ranges[29] = std::numeric_limits<float>::infinity();
  EXPECT_EQ(surfaces::loneReturns(scan), Indices{}) << "the beam beside it met nothing";
  scan.ranges[28] = scan.ranges[29] = std::nanf("");
  scan.ranges[27] = scan.ranges[26] = std::nanf("");
  EXPECT_EQ(surfaces::loneReturns(scan), Indices{}) << "too much beside it is not known";
}

}  // namespace
}  // namespace frontier_pilot
