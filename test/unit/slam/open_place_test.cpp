// Places where hardly any beam returns: odometry carries the pose, and nothing is invented.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "support/drives/open_place.h"
#include "support/drives/tracked_drive.h"

namespace frontier_pilot {
namespace {

using test::TrackedDrive;

/// From one yard over the open place into the other one.
std::vector<Pose2> acrossThePlace() {
  return test::driveAlong({{10.0, 10.0}, {16.0, 11.0}, {40.0, 40.0}, {64.0, 62.0}, {70.0, 70.0}}, 0.5);
}

class OpenPlace : public ::testing::TestWithParam<double> {
 protected:
  OpenPlace() { scanner.range_max = GetParam(); }

  test::Scanner scanner{test::openPlace(), 0.01};
  TrackedDrive drive;
};

INSTANTIATE_TEST_SUITE_P(Ranges, OpenPlace, ::testing::Values(8.0, 15.0, 30.0));

TEST_P(OpenPlace, MAP_1_IsCrossedByOdometryWithoutLosingTheWay) {
  const std::vector<Pose2> poses = acrossThePlace();
  drive.run(poses, scanner);
  EXPECT_EQ(drive.count(slam::MatchVerdict::kLost), 0);
  EXPECT_EQ(drive.count(slam::MatchVerdict::kPoor), 0);
  EXPECT_GT(drive.count(slam::MatchVerdict::kCarried), 10);
  EXPECT_EQ(drive.count(slam::MatchVerdict::kContradicts), 0);
  EXPECT_LT(drive.worst, 0.06 * 84.0) << "odometry alone is 20 m off at the end";
  EXPECT_GT(drive.keyframes.size(), 300U);
}

TEST(OpenGround, MAP_1_AtTheBeginningIsFollowedByWhatComesIntoSight) {
  test::Scanner scanner(test::rooms(), 0.01);
  TrackedDrive drive;
  drive.run(test::aroundTheRooms(), scanner, [](double now, LaserScan2& scan, test::Wheels&) {
    if (now < 0.05) scan.ranges.assign(scan.ranges.size(), std::numeric_limits<float>::infinity());
    return true;
  });
  EXPECT_EQ(drive.count(slam::MatchVerdict::kPoor), 0);
  EXPECT_EQ(drive.count(slam::MatchVerdict::kLost), 0);
  EXPECT_LT(drive.worst, 0.1);
}

TEST(OpenGround, MAP_1_StandingOnItTellsNothingAboutThePose) {
  slam::LocalSlam slam;
  LaserScan2 scan;
  scan.angle_min = -kPi;
  scan.angle_increment = kPi / 180.0;
  scan.range_max = 8.0;
  scan.ranges.assign(360, std::numeric_limits<float>::infinity());
  double driven = 0.0;
  const auto sigmaAfter = [&](double step) {
    scan.stamp += fromSeconds(0.1);
    driven += step;
    const slam::Track track = slam.update(surfaces::readScan(scan), Pose2(driven, 0.0, 0.0)).track;
    return std::sqrt(track.T_local_base.covariance(0, 0));
  };
  double sigma = 0.0;
  for (int i = 0; i < 50; ++i) sigma = sigmaAfter(0.1);
  EXPECT_GT(sigma, 0.01) << "[m]";
  for (int i = 0; i < 20; ++i) EXPECT_GE(sigmaAfter(0.0), sigma - 1e-9);
}

}  // namespace
}  // namespace frontier_pilot
