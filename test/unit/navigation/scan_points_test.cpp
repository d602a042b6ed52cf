#include "navigation/scan_points.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <vector>

#include "frontier_pilot/core/geometry.h"
#include "support/full_circle.h"

namespace frontier_pilot {
namespace {

TEST(PoseHistory, InterpolatesAcrossTheSeamOfTheAngle) {
  navigation::PoseHistory history;
  history.add(timeFromSeconds(1.0), {0.0, 0.0, 3.0});
  history.add(timeFromSeconds(2.0), {1.0, 0.0, -3.0});
  const auto middle = history.at(timeFromSeconds(1.5));
  ASSERT_TRUE(middle.has_value());
  EXPECT_NEAR(middle->x, 0.5, 1e-12);
  EXPECT_NEAR(std::abs(middle->yaw), kPi, 1e-9);
  EXPECT_FALSE(history.at(timeFromSeconds(3.0)).has_value()) << "too far beyond what is known";
}

TEST(ScanPoints, TakesATooNearReadingForTheFootprintsEdge_NAV_4) {
  LaserScan2 scan;
  scan.angle_increment = kPi;
  scan.range_min = 0.12;
  scan.range_max = 8.0;
  scan.T_base_sensor = {-0.03, 0.0, 0.0};
  scan.ranges = {1.0F, 0.05F};
  const navigation::ScanPoints points = navigation::scanPoints(scan, {10.0, 0.0, 0.0}, Outline::disc(0.105));
  ASSERT_EQ(points.size(), 2U);
  EXPECT_NEAR(static_cast<double>(points.x[0]), 10.97, 1e-5);
  EXPECT_NEAR(static_cast<double>(points.x[1]), 10.0 - 0.105, 1e-5);
}

// [FLT-1] [NAV-4]
TEST(ScanPoints, AreNotToDriveByWhenOnlyATenthOfTheBeamsIsValid) {
  LaserScan2 scan = test::fullCircle(0.0);
  EXPECT_TRUE(navigation::isUsable(scan));
  std::fill(scan.ranges.begin() + 36, scan.ranges.end(), 0.0F);
  EXPECT_FALSE(navigation::isUsable(scan));
  EXPECT_FALSE(navigation::isUsable(LaserScan2()));
}

}  // namespace
}  // namespace frontier_pilot
