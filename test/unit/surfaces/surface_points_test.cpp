#include "frontier_pilot/surfaces/surface_points.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "support/ascii_world.h"
#include "support/drives/drive.h"

namespace frontier_pilot {
namespace {

/// A room of 4 m x 2 m with a pillar, seen from `pose`.
LaserScan2 scanOfRoom(test::Scanner scanner, const Pose2& pose) { return scanner.scan(pose, timeFromSeconds(1.0)); }

Grid<std::uint8_t> scannedRoom() {
  GridGeometry geometry;
  geometry.width = 100;
  geometry.height = 60;
  Grid<std::uint8_t> solid(geometry, 0);
  for (int x = 0; x < 100; ++x) {
    for (int y = 0; y < 60; ++y) {
      if (x < 10 || x >= 90 || y < 10 || y >= 50) solid[Cell{x, y}] = 1;
    }
  }
  return solid;
}

TEST(ReadScan, GivesTheReturnsInTheBaseFrameHoweverTheScannerIsMounted) {
  for (const Pose2& mount : {Pose2(), Pose2(0.3, 0.1, 2.0), Pose2(-0.2, 0.0, -0.7)}) {
    test::Scanner scanner(scannedRoom(), 0.0);
    scanner.T_base_sensor = mount;
    const Pose2 pose(2.0, 1.5, 0.4);
    const surfaces::SurfacePoints points = surfaces::readScan(scanOfRoom(scanner, pose)).points;
    EXPECT_EQ(points.size(), 360U);
    for (const surfaces::SurfacePoint& point : points) {
      const Vec2 p = pose * point.position;
      const double to_wall =
          std::min({std::abs(p.x() - 0.5), std::abs(p.x() - 4.5), std::abs(p.y() - 0.5), std::abs(p.y() - 2.5)});
      EXPECT_LT(to_wall, 1e-3);
    }
  }
}

TEST(ReadScan, KnowsWhichWayEachWallLooks) {
  test::Scanner scanner(scannedRoom(), 0.01);
  const Pose2 pose(2.0, 1.5, 0.4);
  const surfaces::SurfacePoints points = surfaces::readScan(scanOfRoom(scanner, pose)).points;
  int with_normal = 0;
  for (const surfaces::SurfacePoint& point : points) {
    if (!point.hasNormal()) continue;
    ++with_normal;
    const Vec2 p = pose * point.position;
    const Vec2 normal = Pose2(0.0, 0.0, pose.yaw) * point.normal;
    EXPECT_NEAR(normal.norm(), 1.0, 1e-9);
    EXPECT_GT(normal.dot(pose.position() - p), 0.0) << "towards the robot";
    const bool at_side = std::abs(p.x() - 0.5) < 0.3 || std::abs(p.x() - 4.5) < 0.3;
    EXPECT_TRUE(at_side || std::abs(normal.x()) < 0.3);
  }
  EXPECT_GT(with_normal, 330);
}

TEST(ReadScan, MAP_1_TakesTheNormalOfAWallUpToItsCornersHoweverManyBeamsThereAre) {
  for (const std::size_t beams : {360U, 2000U}) {
    test::Scanner scanner(scannedRoom(), 0.01);
    scanner.beams = beams;
    const Pose2 pose(1.1, 1.1, 0.4);  // 0.6 m from two of the walls
    double sum = 0.0;
    double count = 0.0;
    for (int i = 0; i < 20; ++i) {
      for (const surfaces::SurfacePoint& point : surfaces::readScan(scanOfRoom(scanner, pose)).points) {
        if (!point.hasNormal()) continue;
        const Vec2 normal = Pose2(0.0, 0.0, pose.yaw) * point.normal;
        const double tilt = std::min(std::abs(normal.x()), std::abs(normal.y()));
        sum += tilt * tilt;
        ++count;
      }
    }
    EXPECT_GT(count, 0.9 * 20.0 * static_cast<double>(beams)) << "nearly every point has one";
    EXPECT_LT(std::sqrt(sum / count), 0.06) << beams << " beams";
  }
}

TEST(ReadScan, MAP_1_KnowsAWallTheBetterAcrossItTheFlatterItIsSeen) {
  test::Scanner scanner(scannedRoom(), 0.0);
  const Pose2 pose(2.0, 0.8, 0.0);  // 0.3 m beside a wall
  int count = 0;
  for (const surfaces::SurfacePoint& point : surfaces::readScan(scanOfRoom(scanner, pose)).points) {
    const Vec2 p = pose * point.position;
    if (!point.hasNormal() || std::abs(p.y() - 0.5) > 0.01 || point.position.norm() > 1.0) continue;
    const double facing = 0.3 / point.position.norm();
    EXPECT_LT(point.variance(), 1.2e-4 * facing * facing + 2.5e-5);
    EXPECT_GT(point.variance(), 1e-4 * facing * facing);
    ++count;
  }
  EXPECT_GT(count, 100);
}

TEST(ReadScan, MAP_1_KnowsARoughWallTheWorseTheFlatterItIsSeen) {
  // Steps of 5 cm, every 5 cm, along a wall at 45 degrees: 1.4 m away where the beam meets it at a right angle.
  LaserScan2 scan;
  scan.angle_min = 0.25 * kPi;
  scan.angle_increment = 0.01;
  scan.range_min = 0.1;
  scan.range_max = 8.0;
  const auto isSolid = [](const Vec2& p) { return std::floor(p.x() / 0.05) + std::floor(p.y() / 0.05) >= 40.0; };
  for (std::size_t i = 0; i < 70; ++i) {
    double range = 1.0;
    while (!isSolid(range * direction(scan.angle(i)))) range += 0.001;
    scan.ranges.push_back(static_cast<float>(range));
  }
  double front = 0.0;
  double flat = 0.0;
  const surfaces::SurfacePoints points = surfaces::readScan(scan).points;
  ASSERT_EQ(points.size(), 70U);
  for (std::size_t i = 0; i < 10; ++i) front += 0.1 * points[i].roughness;
  for (std::size_t i = 60; i < 70; ++i) flat += 0.1 * points[i].roughness;
  EXPECT_GT(front, 3e-5) << "more than nothing";
  EXPECT_GT(flat, 2.0 * front);
}

TEST(ReadScan, LeavesOutBeamsThatSayNothingAndKnowsThoseThatMetNothing) {
  LaserScan2 scan;
  scan.angle_increment = 0.01;
  scan.range_min = 0.1;
  scan.range_max = 8.0;
  const float inf = std::numeric_limits<float>::infinity();
  scan.ranges = {1.0F, std::nanf(""), inf, -inf, 0.0F, 9.0F, 0.05F, 1.0F};
  const surfaces::SurfaceScan read = surfaces::readScan(scan);
  ASSERT_EQ(read.points.size(), 2U);
  EXPECT_NEAR(bearing(read.points[1].position), 0.07, 1e-9);
  EXPECT_EQ(read.free, (std::vector<double>{0.02, 0.05}));
  EXPECT_EQ(read.range_max, 8.0);
  EXPECT_EQ(read.usableBeams(), 4U);
  EXPECT_TRUE(surfaces::readScan(LaserScan2{}).points.empty());
}

TEST(ReadScan, SeesNoSurfaceWhereBeamsMeetSinglePoints) {
  LaserScan2 scan;
  scan.angle_increment = 0.05;
  scan.range_min = 0.1;
  scan.range_max = 8.0;
  scan.ranges = {1.0F, 3.0F, 5.0F, 2.0F, 7.0F, 4.0F};
  for (const surfaces::SurfacePoint& point : surfaces::readScan(scan).points) EXPECT_FALSE(point.hasNormal());
}

TEST(Thinned, MAP_1_IsTheSameWhicheverWayTheBeamsRun) {
  test::Scanner scanner(scannedRoom(), 0.01);
  for (int i = 0; i < 20; ++i) {
    const LaserScan2 scan = scanOfRoom(scanner, {1.0 + 0.1 * i, 1.5, 0.3 * i});
    LaserScan2 reversed = scan;
    std::reverse(reversed.ranges.begin(), reversed.ranges.end());
    reversed.angle_min = scan.angle(scan.ranges.size() - 1);
    reversed.angle_increment = -scan.angle_increment;
    const surfaces::SurfacePoints one = surfaces::thinned(surfaces::readScan(scan).points);
    const surfaces::SurfacePoints other = surfaces::thinned(surfaces::readScan(reversed).points);
    ASSERT_EQ(one.size(), other.size());
    for (std::size_t k = 0; k < one.size(); ++k) {
      const surfaces::SurfacePoint& mirrored = other[other.size() - 1 - k];
      EXPECT_LT((one[k].position - mirrored.position).norm(), 1e-6);
      EXPECT_LT((one[k].normal - mirrored.normal).norm(), 1e-6);
      EXPECT_NEAR(one[k].variance() / mirrored.variance(), 1.0, 1e-6);
    }
  }
}

TEST(Thinned, NeverExceedsTheNumberAskedForAndCoversTheSame) {
  test::Scanner scanner(scannedRoom(), 0.0);
  scanner.beams = 2000;
  surfaces::SurfaceParameters parameters;
  parameters.max_points = 60;
  const surfaces::SurfacePoints points = surfaces::readScan(scanOfRoom(scanner, {2.0, 1.5, 0.0})).points;
  const surfaces::SurfacePoints few = surfaces::thinned(points, parameters);
  EXPECT_LE(few.size(), 60U);
  EXPECT_GT(few.size(), 30U);
  for (const surfaces::SurfacePoint& point : points) {
    double nearest = 1e9;
    for (const surfaces::SurfacePoint& other : few)
      nearest = std::min(nearest, (other.position - point.position).norm());
    EXPECT_LT(nearest, 0.6);
  }
}

TEST(Filled, ClosesGapsWithinAWallAndNotBetweenWalls) {
  const Vec2 up(0.0, 1.0);
  const surfaces::SurfacePoints wall = {{{0.0, 0.0}, up, false}, {{0.3, 0.0}, up, true}, {{0.6, 0.0}, up, true},
                                        {{3.0, 0.0}, up, true},  {{3.1, 0.4}, up, true}, {{3.3, 0.4}, up, false}};
  const surfaces::SurfacePoints dense = surfaces::filled(wall);
  EXPECT_EQ(dense.size(), wall.size() + 10);
  for (const surfaces::SurfacePoint& point : dense) {
    EXPECT_TRUE(point.position.x() <= 0.6 || point.position.x() >= 3.0);
    EXPECT_TRUE(point.position.y() == 0.0 || point.position.y() == 0.4);
  }
}

TEST(ReadScan, DoesNotBridgeADoorThatBeamsPass) {
  // A wall 1 m to the left with a door in it, through which nothing is seen; then one with beams that failed.
  LaserScan2 scan;
  scan.angle_min = 0.25 * kPi;
  scan.angle_increment = 0.02;
  scan.range_min = 0.1;
  scan.range_max = 8.0;
  for (std::size_t i = 0; i < 60; ++i) scan.ranges.push_back(static_cast<float>(1.0 / std::sin(scan.angle(i))));
  std::fill_n(scan.ranges.begin() + 20, 3, std::numeric_limits<float>::infinity());
  std::fill_n(scan.ranges.begin() + 40, 3, std::nanf(""));
  const surfaces::SurfacePoints points = surfaces::readScan(scan).points;
  ASSERT_EQ(points.size(), 54U);
  EXPECT_FALSE(points[20].connected) << "beyond the door";
  EXPECT_TRUE(points[37].connected) << "beyond the failed beams";
}

TEST(ReadScan, KnowsTheNormalsOfAWallThatItSeesAtAGrazingAngle) {
  // A corridor of 2 m, with 1 degree between beams, up to 7 m ahead: there successive returns lie 0.9 m apart.
  LaserScan2 scan;
  scan.angle_min = std::asin(1.0 / 7.0);
  scan.angle_increment = kPi / 180.0;
  scan.range_min = 0.1;
  scan.range_max = 8.0;
  for (std::size_t i = 0; i < 60; ++i) scan.ranges.push_back(static_cast<float>(1.0 / std::sin(scan.angle(i))));
  const surfaces::SurfacePoints points = surfaces::readScan(scan).points;
  for (const surfaces::SurfacePoint& point : points) EXPECT_LT(point.normal.y(), -0.99);
  const surfaces::SurfacePoints dense = surfaces::filled(points);
  for (std::size_t i = 1; i < dense.size(); ++i) {
    EXPECT_LT((dense[i].position - dense[i - 1].position).norm(), 0.06) << "no gaps between the beams";
  }
}

TEST(SurfaceOf, IsTheBorderBetweenFreeAndOccupiedCells) {
  const test::AsciiWorld world = test::drawWorld(R"(
    ????
    ?##.
    ?#..
  )",
                                                 0.1);
  const surfaces::SurfacePoints points = surfaces::surfaceOf(world.map);
  ASSERT_EQ(points.size(), 3U);
  EXPECT_EQ(surfaces::surfaceSize(world.map), 3U);
  EXPECT_NEAR(points[0].position.x(), 0.2, 1e-9);
  EXPECT_NEAR(points[0].position.y(), 0.05, 1e-9);
  EXPECT_EQ(points[0].normal, Vec2(1.0, 0.0));
}

}  // namespace
}  // namespace frontier_pilot
