#include "frontier_pilot/mapping/scan_pairing.h"

#include <gtest/gtest.h>

#include "mapping/odometry_buffer.h"

namespace frontier_pilot {
namespace {

LaserScan2 scanAt(double seconds) {
  LaserScan2 scan;
  scan.stamp = timeFromSeconds(seconds);
  return scan;
}

TEST(OdometryBuffer, InterpolatesBetweenNeighboursAndTurnsTheShortWay) {
  mapping::OdometryBuffer buffer;
  buffer.add(timeFromSeconds(1.0), Pose2(1.0, 0.0, 3.0));
  buffer.add(timeFromSeconds(1.1), Pose2(2.0, 1.0, -3.0));
  Pose2 pose;
  ASSERT_EQ(buffer.at(timeFromSeconds(1.05), pose), mapping::OdometryLookup::kFound);
  EXPECT_NEAR(pose.x, 1.5, 1e-9);
  EXPECT_NEAR(pose.y, 0.5, 1e-9);
  EXPECT_NEAR(std::abs(pose.yaw), kPi, 1e-9);
  ASSERT_EQ(buffer.at(timeFromSeconds(1.0), pose), mapping::OdometryLookup::kFound);
  EXPECT_EQ(pose, Pose2(1.0, 0.0, 3.0));
}

TEST(OdometryBuffer, NeverExtrapolatesAndSaysWhichWayItLacks) {
  mapping::OdometryBuffer buffer;
  Pose2 pose(7.0, 7.0, 7.0);
  EXPECT_EQ(buffer.at(timeFromSeconds(1.0), pose), mapping::OdometryLookup::kTooNew);
  buffer.add(timeFromSeconds(1.0), Pose2());
  buffer.add(timeFromSeconds(3.0), Pose2());
  EXPECT_EQ(buffer.at(timeFromSeconds(0.9), pose), mapping::OdometryLookup::kTooOld);
  EXPECT_EQ(buffer.at(timeFromSeconds(3.1), pose), mapping::OdometryLookup::kTooNew);
  EXPECT_EQ(buffer.at(timeFromSeconds(2.0), pose), mapping::OdometryLookup::kGap);
  EXPECT_EQ(pose, Pose2(7.0, 7.0, 7.0)) << "untouched unless found";
}

TEST(OdometryBuffer, FLT_1_KeepsALimitedNumberHoweverFastItComes) {  // [FLT-1]
  mapping::OdometryBuffer buffer;
  Pose2 pose;
  for (int i = 0; i < 6000; ++i) buffer.add(Time{} + Duration(i), {});
  EXPECT_EQ(buffer.at(Time{} + Duration(999), pose), mapping::OdometryLookup::kTooOld);
  EXPECT_EQ(buffer.at(Time{} + Duration(1000), pose), mapping::OdometryLookup::kFound);
}

TEST(OdometryBuffer, KeepsALimitedTimeAndRestartsWhenTheClockIsSetBack) {
  mapping::OdometryBuffer buffer;
  for (int i = 0; i <= 1000; ++i) buffer.add(timeFromSeconds(0.01 * i), Pose2());
  Pose2 pose;
  EXPECT_EQ(buffer.at(timeFromSeconds(4.9), pose), mapping::OdometryLookup::kTooOld);
  EXPECT_EQ(buffer.at(timeFromSeconds(5.1), pose), mapping::OdometryLookup::kFound);
  buffer.add(timeFromSeconds(2.0), Pose2());
  EXPECT_EQ(buffer.at(timeFromSeconds(5.1), pose), mapping::OdometryLookup::kTooNew);
}

// [MAP-1] paired by stamp
TEST(ScanPairing, GivesAScanTheOdometryOfItsStampWhicheverCameFirst_MAP_1) {
  mapping::ScanPairing pairing;
  pairing.addScan(scanAt(1.05));
  EXPECT_FALSE(pairing.next(timeFromSeconds(1.06))) << "its odometry may still come";
  pairing.addOdometry(timeFromSeconds(1.0), Pose2(1.0, 0.0, 0.0));
  EXPECT_FALSE(pairing.next(timeFromSeconds(1.07)));
  pairing.addOdometry(timeFromSeconds(1.1), Pose2(2.0, 0.0, 0.0));
  const auto paired = pairing.next(timeFromSeconds(1.1));
  ASSERT_TRUE(paired && paired->T_odom_base);
  EXPECT_NEAR(paired->T_odom_base->x, 1.5, 1e-9);
  EXPECT_FALSE(pairing.next(timeFromSeconds(1.1)));
}

// [MAP-4] no odometry
TEST(ScanPairing, GivesUpWaitingAfterAWhile_MAP_4) {
  mapping::ScanPairing pairing;
  pairing.addOdometry(timeFromSeconds(1.0), Pose2());
  pairing.addScan(scanAt(1.05));
  EXPECT_FALSE(pairing.next(timeFromSeconds(1.3)));
  const auto paired = pairing.next(timeFromSeconds(1.4));
  ASSERT_TRUE(paired);
  EXPECT_FALSE(paired->T_odom_base);
}

TEST(ScanPairing, LetsNoScanFromTheFutureBlockTheOthers) {
  mapping::ScanPairing pairing;
  pairing.addScan(scanAt(100.0));
  const auto paired = pairing.next(timeFromSeconds(1.0));
  ASSERT_TRUE(paired);
  EXPECT_FALSE(paired->T_odom_base);
}

TEST(ScanPairing, HoldsALimitedNumberOfScans) {
  mapping::ScanPairing pairing;
  for (int i = 0; i < 25; ++i) pairing.addScan(scanAt(1.0 + 0.001 * i));
  int given_up = 0;
  while (pairing.next(timeFromSeconds(1.1))) ++given_up;
  EXPECT_EQ(given_up, 5);
}

// [SCN-1] [MAP-1]
TEST(ScanPairing, WaitsForTheLastBeamOfARollingScanAndPairsItAtItsMiddle_SCN_1) {
  mapping::ScanPairing pairing;
  LaserScan2 scan = scanAt(1.0);
  scan.ranges.assign(201, 1.0F);
  scan.time_increment = 0.001;
  for (double t = 0.9; t < 1.15; t += 0.05) pairing.addOdometry(timeFromSeconds(t), Pose2(t, 0.0, 0.0));
  pairing.addScan(scan);
  EXPECT_FALSE(pairing.next(timeFromSeconds(1.16))) << "odometry may still come";
  pairing.addOdometry(timeFromSeconds(1.21), Pose2(1.21, 0.0, 0.0));
  const auto paired = pairing.next(timeFromSeconds(1.21));
  ASSERT_TRUE(paired && paired->T_odom_base);
  EXPECT_TRUE(paired->covered);
  EXPECT_NEAR(paired->T_odom_base->x, 1.1, 1e-6);
  EXPECT_NEAR(toSeconds(paired->scan.stamp), 1.1, 1e-6);
  EXPECT_NEAR(paired->scan.mount(0).x, -0.1, 1e-6);
  EXPECT_NEAR(paired->scan.mount(200).x, 0.1, 1e-6);
}

/// What a scan at 1.45 s gets whose robot is at `x` = 1 m until odometry jumps to 5 m, at 1.4 s.
std::optional<Pose2> inTheMidstOfAJump(bool trusted) {
  mapping::ScanPairing pairing;
  mapping::OdometryAnchorParameters parameters;
  parameters.trusted = trusted;
  mapping::OdometryAnchor anchor(parameters);
  int withheld = 0;
  for (int i = 0; i < 10; ++i) {
    const double seconds = 1.0 + 0.1 * i;
    withheld += pairing.addOdometry(timeFromSeconds(seconds), {i < 4 ? 1.0 : 5.0, 0.0, 0.0}, anchor) ? 0 : 1;
  }
  EXPECT_EQ(withheld, 2) << "the jump was not confirmed yet";
  EXPECT_EQ(anchor.resets(), 1U);
  pairing.addScan(scanAt(1.45));
  const auto paired = pairing.next(timeFromSeconds(2.0));
  EXPECT_TRUE(paired);
  return paired ? paired->T_odom_base : std::nullopt;
}

// [MAP-4]
TEST(ScanPairing, HasNoOdometryForAScanFromTheMidstOfAJumpThatTheRobotMakes_MAP_4) {
  EXPECT_FALSE(inTheMidstOfAJump(true)) << "such as half way, where it never was";
}

// [FLT-1]
TEST(ScanPairing, GoesOnFromThePoseOfBeforeWhereOdometryAloneHasJumped_FLT_1) {
  EXPECT_EQ(inTheMidstOfAJump(false), Pose2(1.0, 0.0, 0.0));
}

}  // namespace
}  // namespace frontier_pilot
