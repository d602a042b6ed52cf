#include "frontier_pilot/core/laser_scan.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "frontier_pilot/core/robot_model.h"
#include "support/full_circle.h"

namespace frontier_pilot {
namespace {

constexpr float kInf = std::numeric_limits<float>::infinity();

void expectReading(float range, RangeKind kind, double distance) {
  const RangeReading reading = readRange(range, 0.12, 3.5);
  EXPECT_EQ(reading.kind, kind) << range;
  EXPECT_DOUBLE_EQ(reading.distance, distance) << range;
}

// [AVO-2]
TEST(ReadRange, FollowsTheConventionsOfLaserScanAndRep117) {
  expectReading(std::nanf(""), RangeKind::kInvalid, 0.0);
  expectReading(0.0F, RangeKind::kInvalid, 0.0);
  expectReading(-1.0F, RangeKind::kInvalid, 0.0);
  expectReading(-kInf, RangeKind::kTooNear, 0.12);
  expectReading(0.05F, RangeKind::kTooNear, 0.12);
  expectReading(1.5F, RangeKind::kHit, 1.5);
  expectReading(3.49F, RangeKind::kHit, static_cast<double>(3.49F));
  expectReading(3.5F, RangeKind::kFree, 3.5);
  expectReading(3.6F, RangeKind::kFree, 3.5);
  expectReading(kInf, RangeKind::kFree, 3.5);
}

TEST(RobotLimits, ClampKeepsTheSignAndAccelerationIsBoundedPerAxis) {
  RobotLimits limits;
  EXPECT_EQ(clamp({-9.0, 9.0}, limits), (Twist2{-limits.max_linear, limits.max_angular}));
  EXPECT_EQ(clamp({0.1, -0.2}, limits), (Twist2{0.1, -0.2}));
  limits.max_linear_acc = 1.0;
  limits.max_angular_acc = 2.0;
  EXPECT_EQ(limitAcceleration({1.0, -1.0}, {0.0, 0.0}, limits, 0.1), (Twist2{0.1, -0.2}));
  EXPECT_EQ(limitAcceleration({0.05, 0.1}, {0.0, 0.0}, limits, 0.1), (Twist2{0.05, 0.1}));
}

TEST(LaserScan, ThatIsTooDenseKeepsEveryNthBeamWhereItPointed_FLT_1) {
  LaserScan2 scan;
  scan.angle_min = -1.0;
  scan.angle_increment = 0.01;
  for (int beam = 0; beam < 100; ++beam) scan.ranges.push_back(static_cast<float>(beam));
  const LaserScan2 whole = withAtMost(100, scan);
  EXPECT_EQ(whole.ranges, scan.ranges);
  EXPECT_EQ(whole.angle_increment, scan.angle_increment);
  const LaserScan2 third = withAtMost(40, scan);
  ASSERT_EQ(third.ranges.size(), 34U);
  for (std::size_t beam = 0; beam < third.ranges.size(); ++beam) {
    const auto original = static_cast<std::size_t>(third.ranges[beam]);
    EXPECT_EQ(original, 3 * beam);
    EXPECT_NEAR(third.angle(beam), scan.angle(original), 1e-12);
  }
}

/// The scan with nothing said by the beams within 60 degrees of `direction` in the robot's frame.
LaserScan2 blindTowards(double direction, double mounted_at, float said) {
  LaserScan2 scan = test::fullCircle(mounted_at);
  for (std::size_t i = 0; i < scan.ranges.size(); ++i) {
    if (std::abs(angleDifference(mounted_at + scan.angle(i), direction)) < kPi / 3.0) scan.ranges[i] = said;
  }
  return scan;
}

// [FLT-1] [NAV-4]
TEST(ScanView, IsNotToDriveByWhenItSaysNothingOfWhatIsAhead) {
  const float nan = std::nanf("");
  for (const double mounted_at : {0.0, kPi, 1.0}) {
    EXPECT_TRUE(looksAhead(test::fullCircle(mounted_at)));
    EXPECT_FALSE(looksAhead(blindTowards(0.0, mounted_at, nan)));
    EXPECT_TRUE(looksAhead(blindTowards(kPi, mounted_at, nan))) << "only behind";
    EXPECT_TRUE(looksAhead(blindTowards(0.0, mounted_at, std::numeric_limits<float>::infinity())))
        << "no return is an answer";
    EXPECT_TRUE(looksAhead(blindTowards(0.0, mounted_at, 0.0F))) << "many drivers say 0 for no return";
  }
  LaserScan2 backwards = test::fullCircle(0.0);
  backwards.angle_min = kPi / 2.0;
  backwards.ranges.resize(180);
  EXPECT_FALSE(looksAhead(backwards)) << "it does not look ahead";
  backwards.ranges.resize(1);
  EXPECT_FALSE(looksAhead(backwards)) << "one beam, to the side";
  LaserScan2 short_sighted = test::fullCircle(0.0);
  short_sighted.range_max = 0.4;
  EXPECT_FALSE(looksAhead(short_sighted)) << "it sees an obstacle when it is too late";
  EXPECT_FALSE(looksAhead(LaserScan2()));
}

}  // namespace
}  // namespace frontier_pilot
