#include "tools/log_mapping.h"

#include <gtest/gtest.h>

#include "frontier_pilot/core/motion.h"

namespace frontier_pilot {
namespace {

/// A drive of a metre a second along a curve, by odometry.
logs::Trajectory curve(int seconds) {
  logs::Trajectory odometry;
  Pose2 pose(100.0, 50.0, 0.0);
  for (int i = 0; i <= seconds; ++i) {
    odometry.push_back({timeFromSeconds(i), pose});
    pose = integrate(pose, {1.0, 0.2}, 1.0);
  }
  return odometry;
}

void expectNear(const Pose2& a, const Pose2& b) { EXPECT_FALSE(isJump(a, b, 1e-9, 1e-9)) << a.x << " " << b.x; }

TEST(BentOdometry, IsOdometryWithoutAnchors) { EXPECT_EQ(tools::bend(curve(3), {}).back().pose, curve(3).back().pose); }

TEST(BentOdometry, GoesThroughItsAnchorsAndIsOdometryBetweenOnesThatAgree) {
  const logs::Trajectory odometry = curve(10);
  const Pose2 T_map_odom(3.0, -20.0, 1.2);
  logs::Trajectory anchors;
  for (const std::size_t i : {2U, 5U}) anchors.push_back({odometry[i].stamp, T_map_odom * odometry[i].pose});
  const logs::Trajectory bent = tools::bend(odometry, anchors);
  ASSERT_EQ(bent.size(), odometry.size());
  for (std::size_t i = 0; i < bent.size(); ++i) expectNear(bent[i].pose, T_map_odom * odometry[i].pose);
}

TEST(BentOdometry, SpreadsADisagreementOverTheWayBetweenTwoAnchors) {
  const logs::Trajectory odometry = curve(10);
  logs::Trajectory anchors;
  anchors.push_back({odometry[4].stamp, odometry[4].pose});
  const Pose2& end = odometry[8].pose;
  anchors.push_back({odometry[8].stamp, {end.x + 0.4, end.y, end.yaw + 0.04}});
  const logs::Trajectory bent = tools::bend(odometry, anchors);
  expectNear(bent[4].pose, odometry[4].pose);
  expectNear(bent[8].pose, anchors[1].pose);
  EXPECT_NEAR(bent[5].pose.yaw - odometry[5].pose.yaw, 0.01, 1e-9);
  EXPECT_NEAR((bent[6].pose.position() - odometry[6].pose.position()).norm(), 0.2, 0.05);
}

// [FLT-1] A submap that held both ends of the jump would need more memory than there is.
TEST(LogMapping, OutlivesOdometryThatJumpsAcrossTheCountry_FLT_1) {
  logs::ScanLog log;
  for (const double x : {999'999.0, -999'999.0, 0.0, 0.5, 5e5}) {
    logs::LogRecord record;
    record.T_odom_base = {x, -x, 0.0};
    record.scan.stamp = timeFromSeconds(static_cast<double>(log.records.size()));
    record.scan.angle_min = -1.0;
    record.scan.angle_increment = 0.02;
    record.scan.range_max = 10.0;
    record.scan.ranges.assign(100, 2.0F);
    log.records.push_back(record);
  }
  mapping::Mapper mapper;
  const tools::MappedDrive drive = tools::mapLog(log, mapper);
  ASSERT_EQ(drive.corrected.size(), log.records.size());
  for (const StampedPose2& entry : drive.corrected) EXPECT_TRUE(entry.pose.isFinite());
}

}  // namespace
}  // namespace frontier_pilot
