// Places where hardly any beam returns: odometry carries the pose, and nothing is invented.

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace frontier_pilot
