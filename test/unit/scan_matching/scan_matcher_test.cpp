#include "frontier_pilot/scan_matching/scan_matcher.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>

#include "frontier_pilot/core/motion.h"
#include "frontier_pilot/scan_matching/correlative_search.h"
#include "scan_matching/surfel_map.h"
#include "support/drives/drive.h"

namespace frontier_pilot {
namespace {

void fill(Grid<std::uint8_t>& solid, const CellRect& cells, std::uint8_t value) {
  for (int y = cells.y; y < cells.y + cells.height; ++y) {
    for (int x = cells.x; x < cells.x + cells.width; ++x) solid[Cell{x, y}] = value;
  }
}

Grid<std::uint8_t> block(int width, int height) {
  GridGeometry geometry;
  geometry.width = width;
  geometry.height = height;
  return Grid<std::uint8_t>(geometry, 1);
}

/// 5 m x 4 m, with a thin wall that reaches into it.
Grid<std::uint8_t> matchedRoom() {
  Grid<std::uint8_t> solid = block(120, 100);
  fill(solid, {10, 10, 100, 80}, 0);
  fill(solid, {60, 10, 1, 45}, 1);
  return solid;
}

/// 30 m x 2 m.
Grid<std::uint8_t> corridor() {
  Grid<std::uint8_t> solid = block(620, 60);
  fill(solid, {10, 10, 600, 40}, 0);
  return solid;
}

/// A map of what is seen on a straight drive.
scan_matching::SurfaceMap mapAlong(test::Scanner& scanner, const Pose2& from, const Vec2& step, int count) {
  scan_matching::SurfaceMap map;
  for (int i = 0; i < count; ++i) {
    const Pose2 pose(from.position() + i * step, from.yaw);
    map.add(surfaces::filled(surfaces::readScan(scanner.scan(pose, timeFromSeconds(i))).points), pose);
  }
  return map;
}

surfaces::SurfacePoints look(test::Scanner& scanner, const Pose2& pose) {
  return surfaces::thinned(surfaces::readScan(scanner.scan(pose, timeFromSeconds(100.0))).points);
}

TEST(Refine, FindsThePoseWithinMillimetres) {
  test::Scanner scanner(matchedRoom(), 0.01);
  const scan_matching::SurfaceMap map = mapAlong(scanner, {1.2, 1.0, 0.2}, {0.05, 0.05}, 20);
  for (int i = 0; i < 20; ++i) {
    const Pose2 truth(1.2 + 0.05 * i, 2.0 + 0.03 * i, 0.3 * i);
    const Pose2 start = truth * Pose2(0.03, -0.04, 0.02);
    const scan_matching::Refinement refined = scan_matching::refine(map, look(scanner, truth), start, std::nullopt, {});
    EXPECT_FALSE(isJump(truth, refined.pose, 0.005, 0.002))
        << i << ": " << (refined.pose.position() - truth.position()).transpose() << " m, "
        << angleDifference(refined.pose.yaw, truth.yaw) << " rad";
    EXPECT_GT(refined.inliers, 0.8);
  }
}

TEST(Refine, KeepsTheTwoSidesOfAThinWallApart) {
  test::Scanner scanner(matchedRoom(), 0.01);
  // Only the left side of the wall at x = 3.0 ... 3.05 m was seen; from the right one its other side is seen.
  const scan_matching::SurfaceMap map = mapAlong(scanner, {1.2, 1.0, 0.0}, {0.0, 0.05}, 10);
  surfaces::SurfacePoints other_side = {{{3.05, 1.0}, {1.0, 0.0}}, {{3.05, 1.1}, {1.0, 0.0}}};
  for (const surfaces::SurfacePoint& point : other_side) EXPECT_EQ(map.surfels().nearest(point), nullptr);
  for (surfaces::SurfacePoint& point : other_side) point.normal = {-1.0, 0.0};
  for (const surfaces::SurfacePoint& point : other_side) {
    ASSERT_NE(map.surfels().nearest(point), nullptr);
    EXPECT_NEAR(map.surfels().nearest(point)->x, 3.0, 0.01);
  }
}

TEST(Refine, KnowsThatACorridorSaysNothingAboutThePlaceAlongIt) {
  test::Scanner scanner(corridor(), 0.01);
  const scan_matching::SurfaceMap map = mapAlong(scanner, {14.0, 1.3, 0.0}, {0.2, 0.0}, 15);
  const Pose2 truth(15.5, 1.4, 0.1);
  const scan_matching::Refinement refined = scan_matching::refine(map, look(scanner, truth), truth, std::nullopt, {});
  const double along = refined.information(0, 0);
  const double across = refined.information(1, 1);
  EXPECT_GT(across, 50.0 * along);
}

TEST(Refine, LetsThePriorDecideWhatTheScanDoesNotShow) {
  test::Scanner scanner(corridor(), 0.01);
  const scan_matching::SurfaceMap map = mapAlong(scanner, {14.0, 1.3, 0.0}, {0.2, 0.0}, 15);
  const Pose2 truth(15.5, 1.4, 0.1);
  scan_matching::PoseWithCovariance prior;
  prior.pose = Pose2(truth.x + 0.1, truth.y - 0.05, truth.yaw + 0.02);
  prior.covariance = Eigen::Vector3d(0.01, 0.05, 0.02).array().square().matrix().asDiagonal();
  const scan_matching::Refinement refined = scan_matching::refine(map, look(scanner, truth), prior.pose, prior, {});
  EXPECT_NEAR(refined.pose.x, prior.pose.x, 0.01);
  EXPECT_NEAR(refined.pose.y, truth.y, 0.005);
  EXPECT_NEAR(refined.pose.yaw, truth.yaw, 0.003);
}

TEST(Refine, IsAsSureAsItIsRight) {
  // The squared Mahalanobis distance of the errors, which should be 3 in the mean, is of that order.
  test::Scanner scanner(matchedRoom(), 0.01);
  const scan_matching::SurfaceMap map = mapAlong(scanner, {1.2, 1.0, 0.2}, {0.05, 0.05}, 20);
  double sum = 0.0;
  constexpr int kCases = 100;
  for (int i = 0; i < kCases; ++i) {
    const Pose2 truth(1.2 + 0.01 * i, 2.0 + 0.01 * i, 0.3 * i);
    const scan_matching::Refinement refined = scan_matching::refine(map, look(scanner, truth), truth, std::nullopt, {});
    const Eigen::Vector3d error(refined.pose.x - truth.x, refined.pose.y - truth.y,
                                angleDifference(refined.pose.yaw, truth.yaw));
    sum += error.dot(refined.information * error);
  }
  EXPECT_GT(sum / kCases, 0.1) << "far too modest";
  EXPECT_LT(sum / kCases, 6.0) << "far too sure";
}

TEST(Refine, SaysWhenAScanFitsNowhere) {
  test::Scanner scanner(matchedRoom(), 0.01);
  test::Scanner elsewhere(corridor(), 0.01);
  const scan_matching::SurfaceMap map = mapAlong(scanner, {1.2, 1.0, 0.2}, {0.05, 0.05}, 20);
  const scan_matching::Refinement refined =
      scan_matching::refine(map, look(elsewhere, {15.0, 1.0, 0.0}), {1.5, 1.5, 0.7}, std::nullopt, {});
  EXPECT_LT(refined.inliers, 0.4);
}

TEST(Contradictions, AreFewInANewPlaceAndManyInAnother) {
  test::Scanner scanner(matchedRoom(), 0.01);
  // Mapped from the left of the thin wall; the robot then looks around its end, where nothing is known.
  const scan_matching::SurfaceMap map = mapAlong(scanner, {1.2, 1.0, 0.0}, {0.0, 0.02}, 10);
  const Pose2 at_the_end(3.0, 3.2, 0.0);
  EXPECT_LT(scan_matching::inconsistentShare(map, look(scanner, at_the_end), at_the_end), 0.1);
  test::Scanner elsewhere(corridor(), 0.01);
  EXPECT_GT(scan_matching::inconsistentShare(map, look(elsewhere, {15.0, 1.0, 0.0}), {1.2, 1.1, 0.0}), 0.3);
  // A hand in front of the scanner: the walls behind it are known.
  LaserScan2 hand = scanner.scan(at_the_end, timeFromSeconds(1.0));
  hand.ranges.assign(hand.ranges.size(), 0.2F);
  EXPECT_GT(scan_matching::inconsistentShare(map, surfaces::thinned(surfaces::readScan(hand).points), {1.2, 1.1, 0.0}),
            0.7);
}

}  // namespace
}  // namespace frontier_pilot
