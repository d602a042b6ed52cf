// What the mapper with its real corrector does after work in the background has thrown.
#include <gtest/gtest.h>

#include <algorithm>

#include "frontier_pilot/mapping/mapper.h"
#include "support/drives/tracked_drive.h"

namespace frontier_pilot::test {
namespace {

/// A mapper that is driven around the rooms, and takes and abandons work on the way.
class AbandonedWork : public ::testing::Test {
 protected:
  void drive(std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last && i < poses.size(); ++i) {
      const Time stamp = timeFromSeconds(100.0 + 0.1 * static_cast<double>(i));
      const Pose2 T_odom_base = poses[0].inverse() * poses[i];
      mapper.insert(scanner.scan(poses[i], stamp), T_odom_base, stamp);
      worst = std::max(worst, ((mapper.T_map_odom() * T_odom_base).position() - T_odom_base.position()).norm());
    }
  }
  /// Takes the work that there is and lets it fail.
  bool fail() {
    const slam::RevisionWork work = mapper.takeWork();
    return work && mapper.abandonWork();
  }

  std::vector<Pose2> poses = aroundTheRooms();
  Scanner scanner{rooms(), 0.01};
  mapping::Mapper mapper;
  double worst = 0.0;  ///< farthest from the truth [m]
};

// [FLT-1]
TEST_F(AbandonedWork, LeavesMapAndPoseAsTheyAre_FLT_1) {
  drive(0, 100);
  const slam::RevisionWork work = mapper.takeWork();
  ASSERT_TRUE(work);
  drive(100, 150);
  const OccupancyGrid before = mapper.grid();
  const Pose2 T_map_odom = mapper.T_map_odom();
  ASSERT_TRUE(mapper.abandonWork());
  EXPECT_TRUE(mapper.grid().cells() == before.cells());
  EXPECT_EQ(mapper.T_map_odom(), T_map_odom);
}

// [FLT-1]
TEST_F(AbandonedWork, IsTheLastUntilAResetAndScansGoOnWhereTheyBelong_FLT_1) {
  drive(0, 100);
  ASSERT_TRUE(fail());
  drive(100, poses.size());
  EXPECT_FALSE(mapper.takeWork()) << "the back end may be in any state";
  EXPECT_LT(worst, 0.1);
  int misplaced = 0;
  int occupied = 0;
  const Grid<std::uint8_t> solid = rooms();
  const GridGeometry& grid = mapper.grid().geometry();
  for (std::size_t i = 0; i < mapper.grid().size(); ++i) {
    if (!isOccupied(mapper.grid()[i])) continue;
    ++occupied;
    const Cell cell = solid.geometry().cellAt(poses[0] * grid.centre(grid.cell(i)));
    bool near = false;
    for (int k = 0; k < 81; ++k) near = near || solid.get({cell.x + k % 9 - 4, cell.y + k / 9 - 4}, 1) != 0;
    misplaced += near ? 0 : 1;
  }
  EXPECT_GT(occupied, 500);
  EXPECT_EQ(misplaced, 0);
  mapper.reset();
  drive(0, 100);
  EXPECT_TRUE(mapper.takeWork()) << "a new map has a new back end";
}

// Loops are closed again by the new corrector, and the mapper must not go on saying that they are not. [FLT-1]
TEST_F(AbandonedWork, IsOverWithAResetOrAGivenPose_FLT_1) {
  drive(0, 100);
  EXPECT_FALSE(mapper.hasAbandonedWork());
  ASSERT_TRUE(fail());
  EXPECT_TRUE(mapper.hasAbandonedWork());
  const Eigen::Vector3d variances(0.01, 0.01, 0.01);
  ASSERT_TRUE(mapper.locate({mapper.T_map_odom() * (poses[0].inverse() * poses[99]), variances.asDiagonal()}));
  EXPECT_FALSE(mapper.hasAbandonedWork());
  drive(100, 200);
  ASSERT_TRUE(fail());
  EXPECT_TRUE(mapper.hasAbandonedWork());
  mapper.reset();
  EXPECT_FALSE(mapper.hasAbandonedWork());
}

// [FLT-1]
TEST_F(AbandonedWork, IsVoidWhenItEndsAfterAll_FLT_1) {
  drive(0, 100);
  const slam::RevisionWork work = mapper.takeWork();
  ASSERT_TRUE(work);
  ASSERT_TRUE(mapper.abandonWork());
  slam::MapRevision late = work();
  EXPECT_FALSE(mapper.revise(late)) << "whoever abandons work has no result of it to offer";
}

}  // namespace
}  // namespace frontier_pilot::test
