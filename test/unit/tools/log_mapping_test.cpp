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

}  // namespace
}  // namespace frontier_pilot
