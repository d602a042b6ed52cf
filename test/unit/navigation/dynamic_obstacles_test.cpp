#include "navigation/dynamic_obstacles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

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

/// How far it is from the origin along `beam` to a disc around `centre`; infinite if it is not met.
double rangeOfDisc(const Vec2& centre, const Vec2& beam) {
  const double along = beam.dot(centre);
  const double off = std::sqrt(std::max(0.0, centre.squaredNorm() - along * along));
  const bool hit = along > 0.0 && off < kThingRadius;
  return hit ? along - std::sqrt(kThingRadius * kThingRadius - off * off) : std::numeric_limits<double>::infinity();
}

/// A scan by `range(place of the scanner, direction)` in the map frame, a beam for each degree, the first one ahead.
template <class Range>
LaserScan2 scanBy(Range range, const Pose2& T_map_base, double seconds) {
  LaserScan2 scan;
  scan.stamp = timeFromSeconds(seconds);
  scan.angle_increment = kPi / 180.0;
  scan.range_min = 0.1;
  scan.range_max = kSilent;
  for (std::size_t i = 0; i < 360; ++i)
    scan.ranges.push_back(static_cast<float>(range(T_map_base.position(), direction(T_map_base.yaw + scan.angle(i)))));
  return scan;
}

LaserScan2 scanOf(const Vec2& disc, const Pose2& T_map_base, double seconds) {
  return scanBy([&](const Vec2& from, const Vec2& beam) { return rangeOfDisc(disc - from, beam); }, T_map_base,
                seconds);
}

/// The same of an upright square of `side` [m] around `centre`.
LaserScan2 scanOfBox(const Vec2& centre, double side, const Pose2& T_map_base, double seconds) {
  const auto range = [&](const Vec2& from, const Vec2& beam) {
    double enter = 0.0, leave = std::numeric_limits<double>::infinity();
    for (const int axis : {0, 1}) {
      const double unit = std::abs(beam[axis]) < 1e-9 ? 1e-9 : beam[axis];
      const double a = (centre[axis] - 0.5 * side - from[axis]) / unit;
      const double b = (centre[axis] + 0.5 * side - from[axis]) / unit;
      enter = std::max(enter, std::min(a, b));
      leave = std::min(leave, std::max(a, b));
    }
    return enter < leave ? enter : std::numeric_limits<double>::infinity();
  };
  return scanBy(range, T_map_base, seconds);
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
  std::vector<navigation::SeenThing> after(double seconds) const {
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
  EXPECT_NEAR((seen[0].body.velocity - Vec2(-0.5, 0.1)).norm(), 0.0, 0.08);
  EXPECT_NEAR((seen[0].body.centre - (last + 0.3 * Vec2(-0.5, 0.1))).norm(), 0.0, 0.1);
  EXPECT_NEAR(seen[0].body.radius, kThingRadius, 0.05);
}

// [MUL-3]
TEST_F(DynamicObstaclesTest, WhatStandsHasNoVelocityHoweverTheRobotDrivesAndTurns_MUL_3) {
  watch({5.0, 3.5}, Vec2::Zero(), 10, {0.5, 0.8});
  const auto seen = after(0.0);
  ASSERT_EQ(seen.size(), 1U);
  EXPECT_TRUE(seen[0].body.velocity.isZero()) << seen[0].body.velocity.transpose();
}

// [MUL-3]
TEST_F(DynamicObstaclesTest, WhatIsNewHasNoVelocityYet_MUL_3) {
  watch({5.0, 3.0}, {-0.5, 0.0}, 2);
  ASSERT_EQ(after(0.0).size(), 1U);
  EXPECT_TRUE(after(0.0)[0].body.velocity.isZero());
}

// [MUL-3]
TEST_F(DynamicObstaclesTest, WhatIsAtAWallOrWhereNothingIsKnownDoesNotCount_MUL_3) {
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

// [MUL-3] Its middle moves when another side of it comes into view.
TEST_F(DynamicObstaclesTest, ABoxThatTheRobotDrivesByStands_MUL_3) {
  for (const double side : {0.4, 0.7, 1.0}) {
    things.clear();
    T_map_base = {2.0, 3.0, 0.0};
    for (int i = 0; i < 25; ++i) {
      things.update(scanOfBox({3.5, 3.4 + 0.5 * side}, side, T_map_base, now), T_map_base, map);
      T_map_base.x += 0.13;
      now += kPeriod;
      for (const navigation::SeenThing& thing : after(0.0))
        EXPECT_TRUE(thing.body.velocity.isZero()) << side << " m, " << i << ": " << thing.body.velocity.transpose();
    }
  }
}

// [MUL-3]
TEST_F(DynamicObstaclesTest, TheNearestPlaceOfAThingIsTheOneThatIsSeenNearest_MUL_3) {
  T_map_base = {3.0, 3.0, 0.0};
  things.update(scanOfBox({3.0, 4.0}, 1.0, T_map_base, now), T_map_base, map);
  now += kPeriod;
  ASSERT_EQ(after(0.0).size(), 1U);
  EXPECT_NEAR((after(0.0)[0].nearest - Vec2(3.0, 3.5)).norm(), 0.0, 0.02);
}

// [MUL-3] Its nearest side is within 0.15 m of a post.
TEST_F(DynamicObstaclesTest, ThePartOfAThingThatIsBesideAWallCountsAsWell_MUL_3) {
  OccupancyGrid hall = hallWithAWall();
  hall[hall.geometry().cellAt({4.8, 3.13})] = kOccupied;
  map = test::clearanceOf(hall);
  T_map_base = {3.0, 3.0, 0.0};
  watch({5.0, 3.0}, Vec2::Zero(), 3);
  const auto seen = after(0.0);
  ASSERT_EQ(seen.size(), 1U);
  EXPECT_NEAR((seen[0].nearest - Vec2(4.82, 3.0)).norm(), 0.0, 0.02) << seen[0].nearest.transpose();
}

// [MUL-3] A wall is seen a little before where the map shows it.
TEST_F(DynamicObstaclesTest, AWallBesideAThingIsNoPartOfIt_MUL_3) {
  T_map_base = {3.0, 3.0, 0.0};
  OccupancyGrid hall = hallWithAWall();
  for (int y = 0; y < 160; ++y) hall[Cell{78, y}] = kOccupied;  // from x = 3.9 m
  for (int y = 55; y < 160; ++y) hall[Cell{78, y}] = kFree;     // with an opening above y = 2.75 m
  map = test::clearanceOf(hall);
  const auto range = [&](const Vec2& from, const Vec2& beam) {
    const double to_wall = beam.x() > 0.0 ? (3.87 - from.x()) / beam.x() : std::numeric_limits<double>::infinity();
    const bool meets = std::isfinite(to_wall) && from.y() + to_wall * beam.y() < 2.75;
    return std::min(rangeOfDisc(Vec2(4.2, 3.0) - from, beam),
                    meets ? to_wall : std::numeric_limits<double>::infinity());
  };
  things.update(scanBy(range, T_map_base, now), T_map_base, map);
  now += kPeriod;
  ASSERT_EQ(after(0.0).size(), 1U);
  EXPECT_NEAR((after(0.0)[0].nearest - Vec2(4.02, 3.0)).norm(), 0.0, 0.02) << after(0.0)[0].nearest.transpose();
}

// [MUL-3] The first beam is straight ahead.
TEST_F(DynamicObstaclesTest, AThingAheadIsOneAlthoughItIsAtBothEndsOfTheScan_MUL_3) {
  T_map_base = {3.0, 3.0, 0.0};
  watch({5.0, 3.0}, {-0.3, 0.0}, 5);
  const auto seen = after(0.0);
  ASSERT_EQ(seen.size(), 1U);
  EXPECT_NEAR(seen[0].body.radius, kThingRadius, 0.04);
  EXPECT_NEAR((seen[0].body.velocity - Vec2(-0.3, 0.0)).norm(), 0.0, 0.08);
}

// [MUL-3]
TEST_F(DynamicObstaclesTest, TwoThatPassEachOtherCloselyKeepTheirVelocities_MUL_3) {
  for (int i = 0; i < 8; ++i) {
    LaserScan2 both = scanOf({4.6 + 0.1 * i, 3.3}, T_map_base, now);
    const LaserScan2 other = scanOf({5.3 - 0.1 * i, 2.75}, T_map_base, now);
    for (std::size_t beam = 0; beam < 360; ++beam) both.ranges[beam] = std::min(both.ranges[beam], other.ranges[beam]);
    things.update(both, T_map_base, map);
    now += kPeriod;
  }
  const auto seen = after(0.0);
  ASSERT_EQ(seen.size(), 2U);
  EXPECT_NEAR(std::abs(seen[0].body.velocity.x()), 0.5, 0.1);
  EXPECT_NEAR(seen[0].body.velocity.x() + seen[1].body.velocity.x(), 0.0, 0.1);
}

// [MUL-3] [SCN-1] The beams of a scanner that turns are older than its stamp, the first ones most.
TEST_F(DynamicObstaclesTest, WhatARollingScanSawFirstIsOlder_MUL_3_SCN_1) {
  for (const bool reversed : {false, true}) {
    things.clear();
    T_map_base = {3.0, 3.0, 0.0};
    Vec2 disc(3.5, 4.5);  // at the first fifth of the sweep, or at the last
    for (int i = 0; i < 5; ++i) {
      LaserScan2 scan = scanOf(disc, T_map_base, now);
      scan.reversed = reversed;
      scan.time_increment = kPeriod / 360.0;
      scan.moving_mounts.assign(360, Pose2());
      things.update(scan, T_map_base, map);
      last = disc;
      disc += kPeriod * Vec2(-0.6, 0.0);
      now += kPeriod;
    }
    ASSERT_EQ(after(0.0).size(), 1U);
    const double old = (reversed ? 0.2 : 0.8) * kPeriod;
    EXPECT_NEAR(after(0.0)[0].body.centre.x(), last.x() - 0.6 * old, 0.03) << reversed;
  }
}

// [MUL-3]
TEST_F(DynamicObstaclesTest, AStampALittleAheadOfTheClockHidesNothing_MUL_3) {
  watch({5.0, 3.0}, Vec2::Zero(), 3);
  EXPECT_EQ(after(-0.1).size(), 1U);
}

// [MUL-3] [FLT-1]
TEST_F(DynamicObstaclesTest, OfManyThingsTheNearestAreTracked_MUL_3_FLT_1) {
  T_map_base = {5.0, 4.0, 0.0};
  LaserScan2 scan = scanOf({50.0, 50.0}, T_map_base, now);
  for (std::size_t beam = 0; beam + 3 <= 360; beam += 4) {
    for (std::size_t i = 0; i < 3; ++i) scan.ranges[beam + i] = beam > 300 ? 1.0F : 2.0F + 0.5F * (beam % 8 > 0);
  }
  things.update(scan, T_map_base, map);
  const auto seen = things.at(scan.stamp);
  EXPECT_LE(seen.size(), 50U);
  EXPECT_TRUE(std::any_of(seen.begin(), seen.end(), [&](const navigation::SeenThing& thing) {
    return (thing.nearest - T_map_base.position()).norm() < 1.1;
  }));
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
