// A scan without any return means open ground, unless the map has walls there.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "frontier_pilot/grids/ray_casting.h"

namespace frontier_pilot {
namespace {

constexpr float kNothing = std::numeric_limits<float>::infinity();

/// A room of 4 m x 4 m around the origin, in a map of 40 m x 40 m that is free otherwise.
OccupancyGrid room() {
  GridGeometry geometry;
  geometry.resolution = 0.05;
  geometry.origin = Vec2(-20.0, -20.0);
  geometry.width = geometry.height = 800;
  OccupancyGrid map(geometry, kFree);
  for (std::size_t i = 0; i < map.size(); ++i) {
    const Vec2 at = geometry.centre(geometry.cell(i)).cwiseAbs();
    if (std::abs(at.maxCoeff() - 2.0) < 0.05) map[i] = kOccupied;
  }
  return map;
}

LaserScan2 scanOf(float range, double range_max = 8.0) {
  LaserScan2 scan;
  scan.angle_min = -kPi;
  scan.angle_increment = 2.0 * kPi / 360.0;
  scan.range_min = 0.12;
  scan.range_max = range_max;
  scan.ranges.assign(360, range);
  return scan;
}

/// Whether a scanner that saw something at `before` is taken to be blind with the next scan.
bool misses(const LaserScan2& scan, const Pose2& T_map_base, const Pose2& before) {
  const OccupancyGrid map = room();
  const auto is_wall = [&](Cell cell) { return isOccupied(map.get(cell, kFree)); };
  grids::BlindnessCheck check;
  check.isBlind(scanOf(2.0F), before, map.geometry(), is_wall);
  return check.isBlind(scan, T_map_base, map.geometry(), is_wall);
}
bool misses(const LaserScan2& scan, const Pose2& T_map_base) { return misses(scan, T_map_base, T_map_base); }

// [FLT-1]
TEST(MissedWalls, AreNoticedHoweverTheScannerSaysThatItSeesNothing_FLT_1) {
  for (const float nothing : {kNothing, 0.0F, std::nanf(""), 8.0F, 50.0F}) {
    EXPECT_TRUE(misses(scanOf(nothing), Pose2(1.0, -0.5, 0.7))) << nothing;
    EXPECT_FALSE(misses(scanOf(nothing), Pose2(12.0, 12.0, 0.7))) << nothing << " on open ground";
  }
}

TEST(MissedWalls, AreNotThoseBeyondTheScannersReach) {
  EXPECT_FALSE(misses(scanOf(kNothing, 1.5), Pose2()));
  EXPECT_FALSE(misses(scanOf(kNothing, 2.3), Pose2())) << "near the end of its range the map may be off";
  EXPECT_TRUE(misses(scanOf(kNothing, 4.0), Pose2()));
}

TEST(MissedWalls, AreLookedForWhereTheScannerIsMounted) {
  LaserScan2 scan = scanOf(kNothing);
  const Pose2 outside(12.0, 0.0, 0.0);  // of the base
  ASSERT_FALSE(misses(scan, outside));
  scan.T_base_sensor = Pose2(-12.0, 0.5, 1.0);  // no robot is that long, but the room is where it is
  EXPECT_TRUE(misses(scan, outside));
  scan.moving_mounts.assign(scan.ranges.size(), Pose2());
  EXPECT_FALSE(misses(scan, outside)) << "where it was when it measured the beams";
}

TEST(MissedWalls, AreNotMissedByAScannerThatSeesHalfAsWideAsHalfACircle) {
  LaserScan2 scan = scanOf(kNothing);
  scan.ranges.resize(90);
  EXPECT_FALSE(misses(scan, Pose2())) << "a door that opens may be all that it sees";
  scan.ranges.resize(180);
  EXPECT_TRUE(misses(scan, Pose2()));
}

TEST(MissedWalls, AreNotThoseThatAScannerMayMissBecauseTheyAreFarAway) {
  const OccupancyGrid map = room();
  GridGeometry large = map.geometry();
  large.resolution *= 6.0;  // the same room, of 24 m x 24 m
  large.origin *= 6.0;
  const auto is_wall = [&](Cell cell) { return isOccupied(map.get(cell, kFree)); };
  grids::BlindnessCheck check;
  EXPECT_FALSE(check.isBlind(scanOf(12.0F, 25.0), Pose2(), large, is_wall));
  EXPECT_FALSE(check.isBlind(scanOf(kNothing, 25.0), Pose2(), large, is_wall));
}

TEST(MissedWalls, AreNotMissedWhereReturnsHaveFadedOutBefore) {
  EXPECT_FALSE(misses(scanOf(kNothing), Pose2(), Pose2(1.5, 0.0, 0.0))) << "the pose may be off on open ground";
  EXPECT_TRUE(misses(scanOf(kNothing), Pose2(), Pose2(0.5, 0.0, 0.0)));
}

TEST(MissedWalls, AreBelievedToHaveGoneByAScanThatSeesSomething) {
  LaserScan2 scan = scanOf(kNothing);
  std::fill(scan.ranges.begin(), scan.ranges.begin() + 30, 5.0F);
  EXPECT_FALSE(misses(scan, Pose2()));
}

TEST(MissedWalls, AreBelievedToHaveGoneOnOneSide) {
  EXPECT_FALSE(misses(scanOf(kNothing), Pose2(-2.6, 0.0, 0.0))) << "the room lies on one side of the robot";
}

}  // namespace
}  // namespace frontier_pilot
