// Logs whose scans lie a metre or more than half a radian apart, from a scanner that sees only ahead.

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "support/drives/tracked_drive.h"

namespace frontier_pilot {
namespace {

using test::TrackedDrive;

constexpr double kStep = 1.0;  // [m]
constexpr double kTurn = 0.6;  // [rad]

/// Corridors 1.5 m wide that turn a corner every 4 m, with a niche in each; cells of 5 cm.
Grid<std::uint8_t> zigzag() {
  GridGeometry geometry;
  geometry.width = 460;
  geometry.height = 460;
  Grid<std::uint8_t> solid(geometry, 1);
  for (int i = 0; i < 5; ++i) {
    const int at = 20 + 80 * i;
    test::fill(solid, {at, at, 110, 30}, 0);
    test::fill(solid, {at + 80, at, 30, 110}, 0);
    test::fill(solid, {at + 40, at - 8, 10, 8}, 0);
    test::fill(solid, {at + 72, at + 50, 8, 14}, 0);
  }
  return solid;
}

constexpr double kNiche = 0.8;  // [m], from one niche to the next

/// A corridor 2 m wide with a niche every 0.8 m on both sides; cells of 5 cm.
Grid<std::uint8_t> niches() {
  GridGeometry geometry;
  geometry.width = 260;
  geometry.height = 60;
  Grid<std::uint8_t> solid(geometry, 1);
  test::fill(solid, {10, 15, 240, 30}, 0);
  for (int x = 14; x < 240; x += 16) {
    test::fill(solid, {x, 9, 6, 6}, 0);
    test::fill(solid, {x, 45, 6, 6}, 0);
  }
  return solid;
}

/// Along all of the corridors and back.
std::vector<Pose2> alongTheZigzag() {
  std::vector<Vec2> corners;
  for (int i = 0; i < 5; ++i) {
    const double at = 1.75 + 4.0 * i;
    corners.emplace_back(at, at);
    corners.emplace_back(at + 4.0, at);
  }
  for (std::size_t i = corners.size() - 1; i-- > 0;) corners.push_back(corners[i]);
  return test::driveAlong(corners, 0.5);
}

test::Scanner halfView() {
  test::Scanner scanner(zigzag(), 0.01);
  scanner.range_max = 3.0;
  scanner.beams = 180;
  scanner.field_of_view = kPi;
  return scanner;
}

/// The poses of a drive at which a scan is taken: each a step or a turn from the one before it.
std::vector<Pose2> thinnedOut(const std::vector<Pose2>& drive) {
  std::vector<Pose2> poses = {drive.front()};
  for (const Pose2& pose : drive) {
    if (isJump(poses.back(), pose, kStep, kTurn)) poses.push_back(pose);
  }
  return poses;
}

TEST(SparseScans, MAP_1_AreAllPlacedOnTheMap) {
  test::Scanner scanner = halfView();
  TrackedDrive drive;
  drive.rate = 0.5;
  const std::vector<Pose2> poses = thinnedOut(alongTheZigzag());
  drive.run(poses, scanner);
  EXPECT_EQ(drive.count(slam::MatchVerdict::kLost), 0);
  EXPECT_EQ(drive.keyframes.size(), poses.size());
  EXPECT_GT(drive.count(slam::MatchVerdict::kExtended), 0) << "too easy";
  EXPECT_LT(drive.worst, 0.3) << "without closing a loop";
  EXPECT_LT(drive.worst_yaw, 0.05);
}

TEST(SparseScans, MAP_1_WouldBeLostIfTheyDidNotExtendTheMap) {
  test::Scanner scanner = halfView();
  slam::LocalSlamParameters parameters;
  parameters.tracker.sparse_distance = std::numeric_limits<double>::infinity();
  parameters.tracker.sparse_angle = std::numeric_limits<double>::infinity();
  TrackedDrive drive;
  drive.slam = slam::LocalSlam(parameters);
  drive.rate = 0.5;
  drive.run(thinnedOut(alongTheZigzag()), scanner);
  EXPECT_GT(drive.count(slam::MatchVerdict::kPoor) + drive.count(slam::MatchVerdict::kLost), 0);
}

TEST(SparseScans, MAP_1_AreInSubmapsOfSomeMetresRatherThanOfManyScans) {
  test::Scanner scanner = halfView();
  TrackedDrive drive;
  drive.rate = 0.5;
  drive.run(thinnedOut(alongTheZigzag()), scanner);
  ASSERT_FALSE(drive.submaps.empty());
  const double most = slam::LocalSlamParameters().submap_length + 4.0 * kStep;
  for (const auto& submap : drive.submaps) EXPECT_LE(submap->length, most);
}

TEST(SparseScans, MAP_1_WithHardlyAnyReturnAreWhereOdometrySays) {
  test::Scanner scanner = halfView();
  TrackedDrive drive;
  drive.rate = 0.5;
  drive.run({Pose2(1.75, 1.75, 0.0), Pose2(2.75, 1.75, 0.0)}, scanner, [](double now, LaserScan2& scan, test::Wheels&) {
    if (now > 0.0) std::fill(scan.ranges.begin() + 5, scan.ranges.end(), std::numeric_limits<float>::infinity());
    return true;
  });
  EXPECT_EQ(drive.count(slam::MatchVerdict::kCarried), 1);
  EXPECT_EQ(drive.keyframes.size(), 2U);
}

TEST(SparseScans, MAP_1_AreNotThoseOfAFastTurnBeforeASlowScanner) {
  // Another place is shown for a second, at 5 Hz and 2.8 rad/s: it must not become part of the map.
  test::Scanner scanner(test::rooms(), 0.01);
  test::Scanner elsewhere(niches(), 0.01);
  TrackedDrive drive;
  drive.rate = 5.0;
  std::vector<Pose2> poses;
  for (int i = 0; i < 30; ++i) poses.emplace_back(2.0, 2.0, normalizeAngle(0.56 * i));
  drive.run(poses, scanner, [&](double now, LaserScan2& scan, test::Wheels&) {
    if (now > 2.9 && now < 3.9) scan = elsewhere.scan(Pose2(5.0, 1.5, 0.3 + now), scan.stamp);
    return true;
  });
  EXPECT_EQ(drive.count(slam::MatchVerdict::kExtended), 0);
  EXPECT_LT(drive.error.position().norm(), 0.05);
}

TEST(SparseScans, MAP_1_ThatLookLikeThePlaceBeforeDoNotHoldTheRobotThere) {
  // Half of what the second scan shows is new. One niche farther back it would fit completely.
  test::Scanner scanner(niches(), 0.01);
  scanner.range_max = 3.0;
  scanner.beams = 180;
  scanner.field_of_view = kPi;
  TrackedDrive drive;
  drive.rate = 0.25;
  drive.run({Pose2(3.0, 1.5, 0.0), Pose2(3.0 + kNiche, 1.5, 0.0)}, scanner);
  EXPECT_EQ(drive.count(slam::MatchVerdict::kContradicts), 0);
  EXPECT_LT(drive.worst, 0.1);
}

}  // namespace
}  // namespace frontier_pilot
