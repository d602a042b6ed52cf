#include "frontier_pilot/mapping/local_slam.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tracked_drive.h"

namespace frontier_pilot {
namespace {

using test::TrackedDrive;

TEST(LocalSlam, FollowsTheRobotWhereOdometryGoesAstray) {
  test::Scanner scanner(test::rooms(), 0.01);
  TrackedDrive drive;
  const std::vector<Pose2> poses = test::aroundTheRooms();
  drive.run(poses, scanner);
  EXPECT_LT(drive.worst, 0.03);
  EXPECT_LT(drive.worst_yaw, 0.01);
  EXPECT_EQ(drive.count(MatchVerdict::kMatched) + drive.count(MatchVerdict::kFirst), static_cast<int>(poses.size()));
  const Pose2 T_odom_base = drive.slam.T_local_odom().inverse() * (poses.front().inverse() * poses.back());
  EXPECT_TRUE(isJump(T_odom_base, poses.front().inverse() * poses.back(), 0.2, 0.1)) << "odometry alone is no good";
}

TEST(LocalSlam, WorksWithFewAndManyBeamsAndWithHalfAView) {
  for (const std::size_t beams : {90U, 720U, 2000U}) {
    for (const double view : {2.0 * kPi, kPi}) {
      test::Scanner scanner(test::rooms(), 0.01);
      scanner.beams = beams;
      scanner.T_base_sensor = {0.2, -0.1, 0.5};
      scanner.field_of_view = view;
      TrackedDrive drive;
      drive.run(test::aroundTheRooms(), scanner);
      EXPECT_LT(drive.worst, 0.08) << beams << " beams over " << view << " rad";
      EXPECT_LT(drive.worst_yaw, 0.03) << beams << " beams over " << view << " rad";
    }
  }
}

TEST(LocalSlam, WorksWithSlowAndFastScanners) {
  for (const double rate : {5.0, 40.0}) {
    test::Scanner scanner(test::rooms(), 0.01);
    TrackedDrive drive;
    drive.rate = rate;
    drive.run(test::aroundTheRooms(0.5, rate), scanner);
    EXPECT_LT(drive.worst, 0.04) << rate << " Hz";
    EXPECT_LT(drive.worst_yaw, 0.015) << rate << " Hz";
  }
}

TEST(LocalSlam, HandsOutOverlappingSubmapsOfConsecutiveKeyframes) {
  test::Scanner scanner(test::rooms(), 0.01);
  TrackedDrive drive;
  drive.run(test::aroundTheRooms(), scanner);
  ASSERT_GE(drive.submaps.size(), 2U);
  for (std::size_t i = 0; i < drive.keyframes.size(); ++i) {
    EXPECT_EQ(drive.keyframes[i].id, i);
    EXPECT_FALSE(drive.keyframes[i].points.empty());
  }
  const auto whole = static_cast<std::size_t>(drive.slam.parameters().submap_keyframes);
  for (std::size_t i = 0; i < drive.submaps.size(); ++i) {
    const Submap& submap = *drive.submaps[i];
    EXPECT_EQ(submap.id, i);
    ASSERT_EQ(submap.keyframes.size(), whole);
    EXPECT_EQ(submap.keyframes.front(), i * whole / 2) << "the first half is the second half of the one before";
    EXPECT_EQ(submap.keyframes.back(), submap.keyframes.front() + whole - 1);
    EXPECT_EQ(submap.T_local_submap, drive.keyframes[submap.keyframes.front()].T_local_base);
  }
  EXPECT_EQ(drive.slam.active().size(), 2U);
}

TEST(LocalSlam, GivesTheSameForTheSameInput) {
  const auto end = [] {
    test::Scanner scanner(test::rooms(), 0.01);
    TrackedDrive drive;
    drive.run(test::aroundTheRooms(), scanner);
    return drive.slam.T_local_odom();
  };
  EXPECT_EQ(end(), end());
}

TEST(LocalSlam, StartsAnewAfterAReset) {
  test::Scanner scanner(test::rooms(), 0.01);
  TrackedDrive drive;
  drive.run(test::aroundTheRooms(), scanner);
  drive.slam.reset();
  EXPECT_TRUE(drive.slam.active().empty());
  const LocalSlamOutput output =
      drive.slam.update(scanner.scan({2.0, 2.0, 0.0}, timeFromSeconds(1.0)), {5.0, 3.0, 1.0});
  EXPECT_EQ(output.track.verdict, MatchVerdict::kFirst);
  EXPECT_EQ(output.track.T_local_base.pose, Pose2(5.0, 3.0, 1.0));
  ASSERT_TRUE(output.keyframe);
  EXPECT_EQ(output.keyframe->id, 0U);
}

}  // namespace
}  // namespace frontier_pilot
