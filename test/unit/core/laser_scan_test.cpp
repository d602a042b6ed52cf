#include "frontier_pilot/core/laser_scan.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "frontier_pilot/core/robot_model.h"

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

}  // namespace
}  // namespace frontier_pilot
