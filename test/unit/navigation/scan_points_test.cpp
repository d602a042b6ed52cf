#include "navigation/scan_points.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "frontier_pilot/core/geometry.h"

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

LaserScan2 fullCircle(double mounted_at) {
  LaserScan2 scan;
  scan.angle_min = -kPi;
  scan.angle_increment = 2.0 * kPi / 360.0;
  scan.range_min = 0.12;
  scan.range_max = 8.0;
  scan.T_base_sensor = {0.0, 0.0, mounted_at};
  scan.ranges.assign(360, 2.0F);
  return scan;
}

/// The scan with nothing said by the beams within 60 degrees of `direction` in the robot's frame.
LaserScan2 blindTowards(double direction, double mounted_at, float said) {
  LaserScan2 scan = fullCircle(mounted_at);
  for (std::size_t i = 0; i < scan.ranges.size(); ++i) {
    if (std::abs(angleDifference(mounted_at + scan.angle(i), direction)) < kPi / 3.0) scan.ranges[i] = said;
  }
  return scan;
}

// [FLT-1] [NAV-4]
TEST(ScanPoints, AreNotToDriveByWhenTheScannerSaysNothingOfWhatIsAhead) {
  const float nan = std::nanf("");
  for (const double mounted_at : {0.0, kPi, 1.0}) {
    EXPECT_TRUE(navigation::isUsable(fullCircle(mounted_at)));
    EXPECT_FALSE(navigation::isUsable(blindTowards(0.0, mounted_at, nan)));
    EXPECT_TRUE(navigation::isUsable(blindTowards(kPi, mounted_at, nan))) << "only behind";
    EXPECT_TRUE(navigation::isUsable(blindTowards(0.0, mounted_at, std::numeric_limits<float>::infinity())))
        << "no return is an answer";
    EXPECT_TRUE(navigation::isUsable(blindTowards(0.0, mounted_at, 0.0F))) << "many drivers say 0 for no return";
  }
  LaserScan2 backwards = fullCircle(0.0);
  backwards.angle_min = kPi / 2.0;
  backwards.ranges.resize(180);
  EXPECT_FALSE(navigation::isUsable(backwards)) << "it does not look ahead";
  backwards.ranges.resize(1);
  EXPECT_FALSE(navigation::isUsable(backwards)) << "one beam, to the side";
  LaserScan2 short_sighted = fullCircle(0.0);
  short_sighted.range_max = 0.4;
  EXPECT_FALSE(navigation::isUsable(short_sighted)) << "it sees an obstacle when it is too late";
  EXPECT_FALSE(navigation::isUsable(LaserScan2()));
}

}  // namespace
}  // namespace frontier_pilot
