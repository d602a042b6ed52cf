#include "navigation/dynamic_obstacles.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "support/floors/open_floor.h"

namespace frontier_pilot {
namespace {

constexpr double kThingRadius = 0.18;  // [m], of what moves
constexpr double kPeriod = 0.2;        // [s], of the scanner
constexpr double kSilent = 5.0;        // [m]: nothing is so far away

/// A floor of 10 m x 10 m with a wall along its right edge, and unknown beyond y = 8.
OccupancyGrid hallWithAWall() {
  OccupancyGrid grid(GridGeometry{0.05, Vec2::Zero(), 200, 200}, kFree);
  for (int i = 0; i < 200; ++i) {
    grid[Cell{199, i}] = kOccupied;
    for (int y = 160; y < 200; ++y) grid[Cell{i, y}] = kUnknown;
  }
  return grid;
}

/// What a scanner at `T_map_base` sees of a disc, a beam for each degree.
LaserScan2 scanOf(const Vec2& disc, const Pose2& T_map_base, double seconds) {
  LaserScan2 scan;
  scan.stamp = timeFromSeconds(seconds);
  scan.angle_min = -kPi;
  scan.angle_increment = kPi / 180.0;
  scan.range_min = 0.1;
  scan.range_max = kSilent;
  const Vec2 there = T_map_base.inverse() * disc;
  for (int i = 0; i < 360; ++i) {
    const Vec2 beam = direction(scan.angle(static_cast<std::size_t>(i)));
    const double along = beam.dot(there);
    const double off = std::sqrt(std::max(0.0, there.squaredNorm() - along * along));
    const bool hit = along > 0.0 && off < kThingRadius;
    scan.ranges.push_back(hit ? static_cast<float>(along - std::sqrt(kThingRadius * kThingRadius - off * off))
                              : std::numeric_limits<float>::infinity());
  }
  return scan;
}

class DynamicObstaclesTest : public ::testing::Test {
 protected:
  /// The robot and a disc drive on for some scans, and then both are where they are at the last one.
  void watch(Vec2 disc, const Vec2& velocity, int scans, const Twist2& own = {}) {
    for (int i = 0; i < scans; ++i) {
      things.update(scanOf(disc, T_map_base, now), T_map_base, map);
      last = disc;
      disc += kPeriod * velocity;
      T_map_base = integrate(T_map_base, own, kPeriod);
      now += kPeriod;
    }
  }
  std::vector<navigation::MovingDisc> after(double seconds) const {
    return things.at(timeFromSeconds(now - kPeriod + seconds));
  }

  planning::ClearanceMap map = test::clearanceOf(hallWithAWall());
  navigation::DynamicObstacles things;
  Pose2 T_map_base{3.0, 3.0, 0.3};
  Vec2 last = Vec2::Zero();
  double now = 10.0;
};

// [MUL-3]
TEST_F(DynamicObstaclesTest, FollowsWhatMovesAndSaysWhereItIsByNow_MUL_3) {
  watch({6.0, 2.5}, {-0.5, 0.1}, 5);
  const auto seen = after(0.3);
  ASSERT_EQ(seen.size(), 1U);
  EXPECT_NEAR((seen[0].velocity - Vec2(-0.5, 0.1)).norm(), 0.0, 0.06);
  EXPECT_NEAR((seen[0].centre - (last + 0.3 * Vec2(-0.5, 0.1))).norm(), 0.0, 0.1);
  EXPECT_NEAR(seen[0].radius, kThingRadius, 0.05);
}

// [MUL-3]
TEST_F(DynamicObstaclesTest, WhatStandsHasNoVelocityHoweverTheRobotDrivesAndTurns_MUL_3) {
  watch({5.0, 3.5}, Vec2::Zero(), 10, {0.5, 0.8});
  const auto seen = after(0.0);
  ASSERT_EQ(seen.size(), 1U);
  EXPECT_TRUE(seen[0].velocity.isZero()) << seen[0].velocity.transpose();
}

// [MUL-3]
TEST_F(DynamicObstaclesTest, WhatIsNewHasNoVelocityYet_MUL_3) {
  watch({5.0, 3.0}, {-0.5, 0.0}, 2);
  ASSERT_EQ(after(0.0).size(), 1U);
  EXPECT_TRUE(after(0.0)[0].velocity.isZero());
}

// [MUL-3]
TEST_F(DynamicObstaclesTest, WhatIsAtAWallOrWhereNothingIsKnownIsNone_MUL_3) {
  T_map_base = {8.0, 3.0, 0.0};
  watch({10.05, 3.0}, {0.0, 0.4}, 5);
  EXPECT_TRUE(after(0.0).empty());
  T_map_base = {3.0, 7.5, 0.0};
  watch({3.0, 9.0}, {0.4, 0.0}, 5);
  EXPECT_TRUE(after(0.0).empty());
}

// [MUL-3]
TEST_F(DynamicObstaclesTest, WhatIsNoLongerSeenIsForgottenWithinASecond_MUL_3) {
  watch({5.0, 3.0}, {0.0, 0.4}, 5);
  EXPECT_EQ(after(0.4).size(), 1U);
  EXPECT_TRUE(after(1.1).empty());
  watch({50.0, 50.0}, Vec2::Zero(), 4);  // beyond the scanner's range
  EXPECT_TRUE(after(0.0).empty());
}

// [MUL-3]
TEST_F(DynamicObstaclesTest, TwoThatPassEachOtherKeepTheirVelocities_MUL_3) {
  for (int i = 0; i < 8; ++i) {
    LaserScan2 both = scanOf({4.5 + 0.1 * i, 3.5}, T_map_base, now);
    const LaserScan2 other = scanOf({5.2 - 0.1 * i, 2.6}, T_map_base, now);
    for (std::size_t beam = 0; beam < 360; ++beam) both.ranges[beam] = std::min(both.ranges[beam], other.ranges[beam]);
    things.update(both, T_map_base, map);
    now += kPeriod;
  }
  const auto seen = after(0.0);
  ASSERT_EQ(seen.size(), 2U);
  EXPECT_NEAR(std::abs(seen[0].velocity.x()), 0.5, 0.1);
  EXPECT_NEAR(seen[0].velocity.x() + seen[1].velocity.x(), 0.0, 0.1);
}

// [MUL-3] [SCN-1] The beams of a scanner that turns are older than its stamp, the first ones most.
TEST_F(DynamicObstaclesTest, WhatARollingScanSawFirstIsOlder_MUL_3_SCN_1) {
  for (int i = 0; i < 5; ++i) {
    LaserScan2 scan =
        scanOf({1.5, 2.5 + 0.1 * i}, {3.0, 3.0, 0.0}, now);  // behind the robot, where the sweep begins and ends
    scan.time_increment = kPeriod / 360.0;
    scan.moving_mounts.assign(360, Pose2());
    things.update(scan, {3.0, 3.0, 0.0}, map);
    now += kPeriod;
  }
  ASSERT_FALSE(after(0.0).empty());
  EXPECT_NEAR(after(0.0)[0].velocity.y(), 0.5, 0.1);
}

// [MUL-3] [FLT-1]
TEST_F(DynamicObstaclesTest, ScansWithoutASingleNumberShowNothing_MUL_3_FLT_1) {
  LaserScan2 scan = scanOf({5.0, 3.0}, T_map_base, now);
  for (float& range : scan.ranges) range = std::nanf("");
  things.update(scan, T_map_base, map);
  EXPECT_TRUE(things.at(timeFromSeconds(now)).empty());
  things.update(LaserScan2{}, T_map_base, map);
  EXPECT_TRUE(things.at(timeFromSeconds(now)).empty());
}

}  // namespace
}  // namespace frontier_pilot
