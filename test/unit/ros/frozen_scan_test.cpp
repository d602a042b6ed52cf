// A scanner that sends the same scan again and again while the robot moves. [FLT-1]

#include "ros/common/messages/frozen_scan.h"

#include <gtest/gtest.h>

#include <limits>

#include "log_lines.h"

namespace frontier_pilot {
namespace {

LaserScan2 scanOf(std::vector<float> ranges) {
  LaserScan2 scan;
  scan.angle_increment = 0.1;
  scan.range_min = 0.1;
  scan.range_max = 8.0;
  scan.ranges = std::move(ranges);
  return scan;
}

const float kNone = std::numeric_limits<float>::infinity();
const LaserScan2 kRoomScan = scanOf({2.0F, 2.1F, kNone, std::numeric_limits<float>::quiet_NaN()});

// [FLT-1]
TEST(FrozenScan, IsNoticedWhenTheRobotHasMovedOrTurned_FLT_1) {
  FrozenScanWatch watch;
  EXPECT_FALSE(watch.isFrozen(kRoomScan, Pose2()));
  EXPECT_FALSE(watch.isFrozen(kRoomScan, Pose2(0.04, 0.0, 0.0)));
  EXPECT_TRUE(watch.isFrozen(kRoomScan, Pose2(0.06, 0.0, 0.0)));
  FrozenScanWatch turned;
  EXPECT_FALSE(turned.isFrozen(kRoomScan, Pose2()));
  EXPECT_TRUE(turned.isFrozen(kRoomScan, Pose2(0.0, 0.0, -0.2)));
}

// [FLT-1] The robot stands because of it: the scan does not count as a fresh one for that.
TEST(FrozenScan, StaysFrozenUntilAnotherScanComes_FLT_1) {
  FrozenScanWatch watch;
  watch.isFrozen(kRoomScan, Pose2());
  for (int i = 0; i < 5; ++i) EXPECT_TRUE(watch.isFrozen(kRoomScan, Pose2(0.5, 0.0, 0.0)));
  EXPECT_FALSE(watch.isFrozen(scanOf({2.0F, 2.1001F, kNone, kNone}), Pose2(0.5, 0.0, 0.0)));
}

// [FLT-1] Not once for each scan: that filled the log.
TEST(FrozenScan, IsSaidOnceInALongTime_FLT_1) {
  const LogLines log;
  FrozenScanWatch watch;
  watch.isFrozen(kRoomScan, Pose2());
  for (int i = 0; i < 50; ++i) watch.isFrozen(kRoomScan, Pose2(0.5, 0.0, 0.0));
  EXPECT_EQ(log.lines.size(), 1U);
}

// [FLT-1] As by a driver with two buffers that are no longer filled.
TEST(FrozenScan, IsNoticedWhenSeveralScansComeInTurn_FLT_1) {
  FrozenScanWatch watch;
  for (int i = 0; i < 10; ++i)
    EXPECT_FALSE(watch.isFrozen(scanOf({1.0F + 0.1F * static_cast<float>(i)}), Pose2(0.02 * i, 0, 0)));
  for (int i = 0; i < 10; ++i)
    EXPECT_TRUE(watch.isFrozen(scanOf({1.0F + 0.1F * static_cast<float>(i)}), Pose2(1.0, 0, 0)));
}

LaserScan2 roomScanAt(double seconds) {
  LaserScan2 scan = kRoomScan;
  scan.stamp = timeFromSeconds(seconds);
  return scan;
}

// [FLT-1] A robot that stands in a simulator without noise could not move to end that.
TEST(FrozenScan, IsNotOneAfterOdometryOrTheClockWasReset_FLT_1) {
  FrozenScanWatch watch;
  EXPECT_FALSE(watch.isFrozen(roomScanAt(10.0), Pose2(4.0, 2.0, 0.0)));
  EXPECT_FALSE(watch.isFrozen(roomScanAt(10.2), Pose2(4.0, 2.0, 0.0)));
  EXPECT_FALSE(watch.isFrozen(roomScanAt(10.4), Pose2())) << "odometry was reset";
  EXPECT_FALSE(watch.isFrozen(roomScanAt(10.6), Pose2()));
  EXPECT_FALSE(watch.isFrozen(roomScanAt(0.2), Pose2(0.5, 0.0, 0.0))) << "the clock was reset";
  EXPECT_TRUE(watch.isFrozen(roomScanAt(0.4), Pose2(0.7, 0.0, 0.0))) << "now it drives";
}

// [FLT-1]
TEST(FrozenScan, IsNoticedAlsoOfARobotThatDrivesFastAndOfAScannerThatRepeatsItsStamps_FLT_1) {
  FrozenScanWatch watch;
  watch.isFrozen(roomScanAt(10.0), Pose2());
  for (int i = 1; i < 10; ++i) EXPECT_TRUE(watch.isFrozen(roomScanAt(10.0 + 0.5 * i), Pose2(0.8 * i, 0.0, 0.0)));
  EXPECT_TRUE(watch.isFrozen(roomScanAt(14.4), Pose2(7.2, 0.0, 0.0)));
}

// [FLT-1] A simulator without noise repeats the scan of a robot that stands.
TEST(FrozenScan, IsNotOneOfARobotThatStands_FLT_1) {
  FrozenScanWatch watch;
  for (int i = 0; i < 100; ++i) EXPECT_FALSE(watch.isFrozen(kRoomScan, Pose2(1.0, 2.0, 3.0)));
}

// [FLT-1]
TEST(FrozenScan, IsNotOneOfOpenGroundOrWithoutOdometry_FLT_1) {
  const LaserScan2 open = scanOf({kNone, -kNone, 0.0F, 8.0F});  // with a post of the robot
  FrozenScanWatch watch;
  for (int i = 0; i < 10; ++i) EXPECT_FALSE(watch.isFrozen(open, Pose2(i, 0.0, 0.0)));
  FrozenScanWatch blind;
  for (int i = 0; i < 10; ++i) EXPECT_FALSE(blind.isFrozen(kRoomScan, std::nullopt));
  EXPECT_FALSE(blind.isFrozen(kRoomScan, Pose2(7.0, 0.0, 0.0))) << "where it was first seen is not known";
  EXPECT_TRUE(blind.isFrozen(kRoomScan, Pose2(8.0, 0.0, 0.0)));
}

}  // namespace
}  // namespace frontier_pilot
