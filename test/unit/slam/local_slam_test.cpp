#include "slam/front_end/local_slam.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/drives/tracked_drive.h"

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
  EXPECT_EQ(drive.count(slam::MatchVerdict::kMatched) + drive.count(slam::MatchVerdict::kFirst),
            static_cast<int>(poses.size()));
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
  const slam::LocalSlamParameters& parameters = drive.slam.parameters();
  for (std::size_t i = 0; i < drive.submaps.size(); ++i) {
    const slam::Submap& submap = *drive.submaps[i];
    EXPECT_EQ(submap.id, i);
    EXPECT_LE(submap.keyframes.size(), static_cast<std::size_t>(parameters.submap_keyframes));
    EXPECT_LE(submap.length, parameters.submap_length + 4.0 * parameters.keyframe_distance);
    for (std::size_t k = 1; k < submap.keyframes.size(); ++k)
      EXPECT_EQ(submap.keyframes[k], submap.keyframes[k - 1] + 1);
    if (i >= 2) {
      EXPECT_EQ(submap.keyframes.front(), drive.submaps[i - 2]->keyframes.back() + 1)
          << "it begins where the last but one ends: its first half is the second half of the one before";
    }
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
  const slam::LocalSlamOutput output =
      drive.slam.update(surfaces::readScan(scanner.scan({2.0, 2.0, 0.0}, timeFromSeconds(1.0))), {5.0, 3.0, 1.0});
  EXPECT_EQ(output.track.verdict, slam::MatchVerdict::kFirst);
  EXPECT_EQ(output.track.T_local_base.pose, Pose2(5.0, 3.0, 1.0));
  ASSERT_TRUE(output.keyframe);
  EXPECT_EQ(output.keyframe->id, 0U);
}

TEST(LocalSlam, MAP_1_KeepsARobotThatStandsWhereItIs) {
  test::Scanner scanner(test::rooms(), 0.01);
  TrackedDrive drive;
  drive.run(std::vector<Pose2>(100, Pose2(2.0, 2.0, 0.3)), scanner);
  EXPECT_LT(drive.worst, 0.001);
  EXPECT_LT(drive.worst_yaw, 0.0005);
}

TEST(LocalSlam, MAP_1_KeepsItsYawInAMazeOfNarrowCorridors) {
  // Legs of 2 m, 0.6 m wide, around corner after corner: no scan sees far.
  Grid<std::uint8_t> solid(GridGeometry{0.05, Vec2::Zero(), 400, 400}, 1);
  std::vector<Vec2> way = {{1.3, 1.3}};
  for (int i = 0; i < 8; ++i) {
    test::fill(solid, {20 + 40 * i, 20 + 40 * i, 52, 12}, 0);
    test::fill(solid, {60 + 40 * i, 20 + 40 * i, 12, 52}, 0);
    way.push_back({3.3 + 2.0 * i, 1.3 + 2.0 * i});
    way.push_back({3.3 + 2.0 * i, 3.3 + 2.0 * i});
  }
  double sum = 0.0;
  for (unsigned seed = 1; seed <= 5; ++seed) {
    test::Scanner scanner(solid, 0.01, seed);
    TrackedDrive drive;
    drive.run(test::driveAlong(way), scanner);
    sum += drive.error.yaw * drive.error.yaw;
  }
  EXPECT_LT(std::sqrt(sum / 5.0), 0.006) << "[rad], after 32 m and 15 corners";
}

TEST(LocalSlam, MAP_1_KeepsTheLengthOfAWayBetweenRoughWalls) {
  // Walls that zigzag at 45 degrees, made of the edges of cells of 5 cm: what a scan sees of them depends on
  // the angle that it sees them at.
  Grid<std::uint8_t> solid(GridGeometry{0.05, Vec2::Zero(), 560, 80}, 1);
  for (int x = 10; x < 550; ++x) {
    const int half = 20 + std::abs(x % 32 - 16) / 2;
    test::fill(solid, {x, 40 - half, 1, 2 * half}, 0);
  }
  double sum = 0.0;
  for (unsigned seed = 1; seed <= 4; ++seed) {
    test::Scanner scanner(solid, 0.01, seed);
    TrackedDrive drive;
    drive.run(test::driveAlong({{2.0, 2.0}, {26.0, 2.0}}), scanner);
    sum += drive.error.x;
  }
  EXPECT_LT(std::abs(sum / 4.0), 0.06) << "[m], in 24 m; 0.09 where roughness does not count";
}

}  // namespace
}  // namespace frontier_pilot
