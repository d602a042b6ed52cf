#include "slam/back_end/graph_back_end.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <utility>

#include "occupancy/octree_layer.h"
#include "support/drives/ring_drive.h"

namespace frontier_pilot::test {
namespace {

constexpr double kSide = 18.0;
constexpr double kStep = 0.4;
const Pose2 kDrift(0.003, 0.0, 0.001);

slam::GraphBackEnd backEnd() {
  return {slam::GraphSlamParameters(), occupancy::OccupancyMapParameters(), occupancy::ScanInsertionParameters()};
}

/// A drive, handed over keyframe by keyframe.
struct Course {
  std::vector<slam::LoopClosure> closures;
  std::optional<occupancy::OccupancyMap> map;
  Pose2 T_now_first;  ///< all jumps together
  int rendered = 0;
  slam::ClosureCounts counts;

  void run(slam::GraphBackEnd& back_end, DriftingDrive& drive) {
    for (std::size_t i = 0; i < drive.size(); ++i) {
      slam::MapRevision revision = back_end.update({drive.keyframe(i)});
      jumped_without_reason = jumped_without_reason || (revision.closures.empty() && !(revision.T_new_old == Pose2()));
      closures.insert(closures.end(), revision.closures.begin(), revision.closures.end());
      T_now_first = revision.T_new_old * T_now_first;
      counts = revision.counts;
      if (!revision.map) continue;
      map = std::move(revision.map);
      ++rendered;
    }
  }
  bool jumped_without_reason = false;
};

double positionError(const Pose2& a, const Pose2& b) { return (a.position() - b.position()).norm(); }

// [MAP-1]
TEST(GraphBackEnd, ClosesALoopAndStraightensTheTrajectory) {
  DriftingDrive drive(ringPoses(kSide, kStep, 1.3), ringWorld(kSide, true), kDrift);
  const std::size_t last = drive.size() - 1;
  ASSERT_GT(positionError(drive.local(last), drive.truth(last)), 0.7) << "the local map is badly off by then";
  slam::GraphBackEnd back_end = backEnd();
  Course course;
  course.run(back_end, drive);
  ASSERT_FALSE(course.closures.empty());
  EXPECT_FALSE(course.jumped_without_reason);
  for (const slam::LoopClosure& closure : course.closures) {
    const Pose2 truth = drive.truth(closure.reference).inverse() * drive.truth(closure.keyframe);
    EXPECT_LT(positionError(truth, closure.T_reference_keyframe), 0.25) << "no false closure";
  }
  const std::vector<slam::KeyframePose> trajectory = back_end.trajectory();
  ASSERT_EQ(trajectory.size(), drive.size());
  double worst = 0.0;
  for (std::size_t i = 0; i < drive.size(); ++i) {
    worst = std::max(worst, positionError(trajectory[i].T_map_base, drive.truth(i)));
  }
  EXPECT_LT(worst, 0.5);
  EXPECT_LT(positionError(trajectory[last].T_map_base, drive.truth(last)), 0.3);
  // Scans inserted from here on go where the trajectory says.
  EXPECT_LT(positionError(course.T_now_first * drive.local(last), trajectory[last].T_map_base), 0.1);
}

double meanError(const slam::GraphBackEnd& back_end, const DriftingDrive& drive) {
  const std::vector<slam::KeyframePose> trajectory = back_end.trajectory();
  double sum = 0.0;
  for (std::size_t i = 0; i < drive.size(); ++i) sum += positionError(trajectory[i].T_map_base, drive.truth(i));
  return sum / static_cast<double>(drive.size());
}

/// A drive twice around the block on which every eighth step is known by odometry only, and turns too far.
DriftingDrive weakDrive() {
  return {ringPoses(kSide, kStep, 2.0), ringWorld(kSide, true), kDrift, {8, Pose2(0.01, 0.0, 0.015)}};
}

// [MAP-1]
TEST(GraphBackEnd, BendsSubmapsWhereOnlyOdometryConnectsTheirKeyframes) {
  slam::GraphSlamParameters rigid;
  rigid.refinement.weak_share = 2.0;  // never
  slam::GraphBackEnd without{rigid, {}, {}};
  DriftingDrive drive = weakDrive();
  Course course;
  course.run(without, drive);
  slam::GraphBackEnd back_end = backEnd();
  DriftingDrive twin = weakDrive();
  Course refined;
  refined.run(back_end, twin);
  EXPECT_FALSE(refined.jumped_without_reason);
  EXPECT_LT(meanError(back_end, drive), 0.6 * meanError(without, drive));
  const std::size_t last = drive.size() - 1;
  const Pose2 T_map_last = back_end.trajectory()[last].T_map_base;
  EXPECT_LT(positionError(refined.T_now_first * drive.local(last), T_map_last), 0.1) << "the robot goes on from there";
  std::set<std::pair<std::size_t, std::size_t>> pairs;
  for (const slam::LoopClosure& closure : refined.closures) {
    EXPECT_TRUE(pairs.emplace(closure.submap, closure.keyframe).second) << "each closure is told once";
  }
}

// [MAP-1]
TEST(GraphBackEnd, RendersTheMapAgainFromWhereTheKeyframesHaveMovedTo) {
  const Grid<std::uint8_t> world = ringWorld(kSide, true);
  DriftingDrive drive(ringPoses(kSide, kStep, 1.3), world, kDrift);
  slam::GraphBackEnd back_end = backEnd();
  Course course;
  course.run(back_end, drive);
  ASSERT_TRUE(course.map.has_value());
  EXPECT_LT(course.rendered, static_cast<int>(drive.size()) / 4) << "and not for every keyframe";
  const OccupancyGrid& grid = course.map->grid();
  const Pose2 T_world_map = ringPoses(kSide, kStep, 0.0).front();
  int occupied = 0;
  int wrong = 0;
  for (std::size_t i = 0; i < grid.size(); ++i) {
    if (!isOccupied(grid[i])) continue;
    ++occupied;
    const Cell cell = world.geometry().cellAt(T_world_map * grid.geometry().centre(grid.geometry().cell(i)));
    bool near = false;
    for (int y = -6; y <= 6; ++y) {
      for (int x = -6; x <= 6; ++x) near = near || world.get({cell.x + x, cell.y + y}, 1) != 0;
    }
    wrong += near ? 0 : 1;
  }
  EXPECT_GT(occupied, 2000);
  EXPECT_LT(wrong, occupied / 20);
}

/// Lets the middle beam pass between its neighbours and end twice as far away.
void letOneBeamPass(surfaces::SurfaceScan& scan) {
  const std::size_t middle = scan.points.size() / 2;
  scan.points[middle].position *= 2.0;
  scan.lone = {middle};
}

std::vector<std::pair<std::size_t, float>> cellsOf(const occupancy::OccupancyMap& map) {
  std::vector<std::pair<std::size_t, float>> cells;
  map.octree().forEach([&](Cell cell, float log_odds) { cells.emplace_back(map.geometry().index(cell), log_odds); });
  return cells;
}

// [MAP-1]
TEST(GraphBackEnd, RendersEachMapAsIfItWereTheFirstOne) {
  DriftingDrive drive(ringPoses(kSide, kStep, 1.3), ringWorld(kSide, true), kDrift);
  slam::GraphBackEnd back_end = backEnd();
  std::vector<surfaces::SurfaceScan> scans;
  int rendered = 0;
  for (std::size_t i = 0; i < drive.size() && rendered < 2; ++i) {
    slam::PlacedKeyframe placed = drive.keyframe(i);
    letOneBeamPass(placed.keyframe.scan);
    scans.push_back(placed.keyframe.scan);
    const slam::MapRevision revision = back_end.update({std::move(placed)});
    if (!revision.map) continue;
    ++rendered;
    occupancy::OccupancyMap map;
    occupancy::ScanInserter inserter;
    const std::vector<slam::KeyframePose> trajectory = back_end.trajectory();
    for (std::size_t k = 0; k < scans.size(); ++k) inserter.insert(scans[k], trajectory[k].T_map_base, map);
    EXPECT_TRUE(cellsOf(*revision.map) == cellsOf(map)) << "lone returns of an earlier map open nothing";
  }
  ASSERT_EQ(rendered, 2);
}

// [MAP-4]
TEST(GraphBackEnd, MovesNothingAfterAMapWasRefusedUntilTheNextMapBringsAllOfIt) {
  DriftingDrive drive(ringPoses(kSide, kStep, 1.3), ringWorld(kSide, true), kDrift);
  DriftingDrive twin = drive;  // with the same noise
  slam::GraphBackEnd accepted = backEnd();
  Course course;
  course.run(accepted, twin);
  ASSERT_GE(course.rendered, 2);
  slam::GraphBackEnd back_end = backEnd();
  Pose2 T_now_first;
  std::size_t closures = 0;
  int maps = 0;
  for (std::size_t i = 0; i < drive.size(); ++i) {
    slam::MapRevision revision = back_end.update({drive.keyframe(i)});
    maps += revision.map ? 1 : 0;
    if (revision.map && maps == 1) {
      back_end.takeBack(revision);
      continue;
    }
    T_now_first = revision.T_new_old * T_now_first;
    closures += revision.closures.size();
    if (maps == 1) {
      EXPECT_EQ(revision.T_new_old, Pose2()) << "poses wait for the map";
    }
  }
  ASSERT_GE(maps, 2) << "there is another map by and by";
  EXPECT_EQ(closures, course.closures.size()) << "none is lost";
  EXPECT_LT(positionError(T_now_first, course.T_now_first), 1e-6);
}

// [MAP-4]
TEST(GraphBackEnd, TellsHowManyKeyframesTheMapHasNoRoomFor) {
  DriftingDrive drive(ringPoses(kSide, kStep, 1.3), ringWorld(kSide, true), kDrift);
  occupancy::OccupancyMapParameters small;
  small.max_side = 12.0;
  small.growth_step = 1.0;
  slam::GraphBackEnd back_end(slam::GraphSlamParameters(), small, occupancy::ScanInsertionParameters());
  std::vector<slam::PlacedKeyframe> all;
  for (std::size_t i = 0; i < drive.size(); ++i) all.push_back(drive.keyframe(i));
  const slam::MapRevision revision = back_end.update(std::move(all));
  ASSERT_TRUE(revision.map.has_value());
  EXPECT_GT(revision.left_out, 10U);
  EXPECT_LT(revision.left_out, drive.size());
}

TEST(GraphBackEnd, ClosesNoFalseLoopWhereEverySideLooksTheSame) {
  // Half a lap: nothing is seen twice, but the second side looks like the first.
  DriftingDrive drive(ringPoses(kSide, kStep, 0.7), ringWorld(kSide, false), kDrift);
  slam::GraphBackEnd back_end = backEnd();
  Course course;
  course.run(back_end, drive);
  for (const slam::LoopClosure& closure : course.closures) {
    const Pose2 truth = drive.truth(closure.reference).inverse() * drive.truth(closure.keyframe);
    EXPECT_LT(positionError(truth, closure.T_reference_keyframe), 0.3);
  }
}

TEST(GraphBackEnd, LeavesWhatDoesNotDriftWhereItIs) {
  DriftingDrive drive(ringPoses(kSide, kStep, 1.3), ringWorld(kSide, true), Pose2());
  slam::GraphBackEnd back_end = backEnd();
  Course course;
  course.run(back_end, drive);
  EXPECT_LT(course.T_now_first.position().norm(), 0.05);
  EXPECT_LT(std::abs(course.T_now_first.yaw), 0.01);
}

TEST(GraphBackEnd, GivesTheSameMapWhetherKeyframesComeOneByOneOrAllAtOnce) {
  DriftingDrive drive(ringPoses(kSide, kStep, 1.2), ringWorld(kSide, true), kDrift);
  std::vector<slam::PlacedKeyframe> all;
  for (std::size_t i = 0; i < drive.size(); ++i) all.push_back(drive.keyframe(i));
  slam::GraphBackEnd one_by_one = backEnd();
  for (const slam::PlacedKeyframe& keyframe : all) one_by_one.update({keyframe});
  slam::GraphBackEnd at_once = backEnd();
  at_once.update(all);
  const auto a = one_by_one.trajectory();
  const auto b = at_once.trajectory();
  for (std::size_t i = 0; i < a.size(); ++i) EXPECT_TRUE(a[i].T_map_base == b[i].T_map_base);
}

}  // namespace
}  // namespace frontier_pilot::test
