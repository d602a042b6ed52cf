#include "frontier_pilot/fleet/map_merger.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "unit/fleet/seen_from.h"

namespace frontier_pilot {
namespace {

using fleet::MapMerger;
using fleet::MapMergerParameters;
using fleet::MergeState;

constexpr Time kStart{std::chrono::seconds(100)};

MapMergerParameters twoRobots(const Pose2& one, const Pose2& two) {
  MapMergerParameters parameters;
  parameters.robots = {{"one", one.x, one.y, one.yaw}, {"two", two.x, two.y, two.yaw}};
  return parameters;
}

/// A hall of 12 m x 10 m with pillars, in the world's frame.
OccupancyGrid hall() {
  GridGeometry geometry;
  geometry.width = 240;
  geometry.height = 200;
  OccupancyGrid map(geometry, kFree);
  for (int y = 0; y < 200; ++y) {
    for (int x = 0; x < 240; ++x) {
      const bool wall = x < 2 || y < 2 || x > 237 || y > 197;
      if (wall || (x % 60 < 6 && y % 70 < 9)) map[Cell{x, y}] = kOccupied;
    }
  }
  return map;
}

std::int8_t cellAt(const OccupancyGrid& map, const Vec2& point) {
  return map.get(map.geometry().cellAt(point), kUnknown);
}

void give(MapMerger& merger, std::size_t robot, const OccupancyGrid& map) {
  merger.setMap(robot, map, map.geometry().rect(), kStart);
}

const Pose2 kOne(3.0, 4.0, 0.4);
const Pose2 kTwo(6.0, 5.0, -2.0);

// [MUL-1]
TEST(MapMerger, PutsMapsFromKnownStartsTogetherInEachFrame) {
  const OccupancyGrid world = hall();
  const OccupancyGrid one = test::seenFrom(world, kOne, 3.0);
  const OccupancyGrid two = test::seenFrom(world, kTwo, 3.0);
  MapMerger merger(twoRobots(kOne, kTwo));
  give(merger, 0, one);
  give(merger, 1, two);
  for (std::size_t i = 0; i < world.size(); i += 7) {
    const Vec2 point = world.geometry().centre(world.geometry().cell(i));
    const bool known = (point - kOne.position()).norm() < 2.9 || (point - kTwo.position()).norm() < 2.9;
    if (!known) continue;
    EXPECT_FALSE(isUnknown(cellAt(merger.common().map(), kOne.inverse() * point))) << point.transpose();
    EXPECT_FALSE(isUnknown(cellAt(merger.view(0).map(), kOne.inverse() * point))) << point.transpose();
    EXPECT_FALSE(isUnknown(cellAt(merger.view(1).map(), kTwo.inverse() * point))) << point.transpose();
  }
  const Vec2 inside_a_pillar(6.15, 3.7);
  EXPECT_TRUE(isOccupied(cellAt(merger.common().map(), kOne.inverse() * inside_a_pillar)));
  const Pose2 place = merger.place(1).value();
  EXPECT_NEAR((place.position() - (kOne.inverse() * kTwo).position()).norm(), 0.0, 1e-9);
  EXPECT_EQ(merger.place(0), Pose2());
}

TEST(MapMerger, ARobotOfUnknownPlaceWorksAlone) {
  const OccupancyGrid world = hall();
  const OccupancyGrid one = test::seenFrom(world, kOne, 3.0);
  const OccupancyGrid two = test::seenFrom(world, kTwo, 3.0);
  MapMergerParameters parameters = twoRobots(kOne, kTwo);
  parameters.known_starts = false;
  MapMerger merger(parameters);
  EXPECT_EQ(merger.status(1).state, MergeState::kNoMap);
  give(merger, 0, one);
  give(merger, 1, two);
  EXPECT_EQ(merger.status(1).state, MergeState::kPlaceUnknown);
  EXPECT_FALSE(merger.place(1));
  EXPECT_EQ(merger.common().map().cells(), one.cells());
  EXPECT_EQ(merger.view(1).map().cells(), two.cells());
  merger.setPlace(1, kOne.inverse() * kTwo, kStart + std::chrono::seconds(5));
  EXPECT_EQ(merger.status(1).state, MergeState::kMerged);
  EXPECT_EQ(merger.status(1).since, kStart + std::chrono::seconds(5));
  EXPECT_GT(merger.common().map().size(), one.size());
  EXPECT_GT(merger.view(1).map().size(), two.size());
  merger.setPlace(1, std::nullopt, kStart);
  EXPECT_EQ(merger.common().map().cells(), one.cells());
  EXPECT_EQ(merger.view(0).map().cells(), one.cells());
  EXPECT_EQ(merger.view(1).map().cells(), two.cells());
}

// [MUL-1]
TEST(MapMerger, GivesUpAMergeThatContradictsWhatBothHaveSeenUntilItDoesNotAnyMore) {
  const OccupancyGrid world = hall();
  const OccupancyGrid one = test::seenFrom(world, kOne, 5.0);
  const Pose2 wrong = kTwo * Pose2(1.0, 0.7, 0.5);
  OccupancyGrid two = test::seenFrom(world, wrong, 5.0);
  MapMerger merger(twoRobots(kOne, kTwo));
  give(merger, 0, one);
  give(merger, 1, two);
  merger.update(kStart);
  EXPECT_EQ(merger.status(1).state, MergeState::kContradicted);
  EXPECT_GT(merger.status(1).agreement.contradictedShare(), 0.25);
  EXPECT_FALSE(merger.place(1));
  EXPECT_EQ(merger.common().map().cells(), one.cells());
  EXPECT_EQ(merger.view(1).map().cells(), two.cells());
  two = test::seenFrom(world, kTwo, 5.0);  // the robot's mapper has corrected its map
  give(merger, 1, two);
  EXPECT_EQ(merger.status(1).state, MergeState::kContradicted);
  merger.update(kStart + std::chrono::seconds(2));
  EXPECT_EQ(merger.status(1).state, MergeState::kMerged);
  EXPECT_TRUE(merger.place(1));
  EXPECT_GT(merger.status(1).agreement.agreeingShare(), 0.95);
}

TEST(MapMerger, ARobotThatWasMergedBeforeIsSeenByOneThatComesLater) {
  const OccupancyGrid world = hall();
  const OccupancyGrid one = test::seenFrom(world, kOne, 3.0);
  const OccupancyGrid two = test::seenFrom(world, kTwo, 3.0);
  MapMerger early(twoRobots(kOne, kTwo));
  give(early, 0, one);
  give(early, 1, two);
  MapMerger late(twoRobots(kOne, kTwo));
  give(late, 1, two);
  give(late, 0, one);
  for (const std::size_t robot : {0U, 1U}) {
    EXPECT_EQ(early.view(robot).map().geometry(), late.view(robot).map().geometry());
    EXPECT_EQ(early.view(robot).map().cells(), late.view(robot).map().cells());
  }
  EXPECT_EQ(early.common().map().cells(), late.common().map().cells());
}

// [MUL-1] Its map has grown by cells that nobody knows, so none of its cells has changed.
TEST(MapMerger, KeepsTheMapOfARobotWhoseMapHasGrownByUnknownCellsAlone_MUL_1) {
  OccupancyGrid one(GridGeometry{0.05, Vec2::Zero(), 60, 40}, kFree);
  for (int y = 0; y < 40; ++y) one[Cell{20, y}] = kOccupied;
  OccupancyGrid grown(GridGeometry{0.05, Vec2::Zero(), 61, 40}, kUnknown);
  for (int y = 0; y < 40; ++y) std::copy_n(one.row(y), 60, grown.row(y));
  OccupancyGrid two(GridGeometry{0.05, Vec2::Zero(), 60, 40}, kUnknown);
  MapMerger merger(twoRobots(Pose2(), Pose2()));
  give(merger, 0, one);
  give(merger, 1, two);
  give(merger, 0, grown);
  two[Cell{22, 10}] = kOccupied;
  merger.setMap(1, two, CellRect{22, 10, 1, 1}, kStart);
  const Vec2 wall = one.geometry().centre({20, 10});
  EXPECT_TRUE(isOccupied(cellAt(merger.common().map(), wall)));
  EXPECT_TRUE(isOccupied(cellAt(merger.view(0).map(), wall)));
  EXPECT_TRUE(isOccupied(cellAt(merger.view(1).map(), wall)));
  EXPECT_EQ(merger.view(0).map().width(), 61);
}

TEST(MapMerger, RefusesAListThatNamesARobotTwiceOrNotAtAll) {
  MapMergerParameters parameters = twoRobots(kOne, kTwo);
  Problems problems;
  parameters.check(problems);
  EXPECT_TRUE(problems.empty());
  parameters.robots[1].name = "one";
  parameters.robots[0].x = 1e9;
  parameters.check(problems);
  EXPECT_EQ(problems.size(), 2U);
  parameters.robots[0] = {"/one", 0.0, 0.0, 0.0};
  problems.clear();
  parameters.check(problems);
  EXPECT_EQ(problems, Problems{"robots[0]/name: '/one' is no name of a namespace"}) << "the same namespace as 'one'";
  parameters.robots[1].name = "";
  parameters.robots.resize(30, {"other", 0.0, 0.0, 0.0});
  problems.clear();
  parameters.check(problems);
  EXPECT_EQ(problems.front(), "robots: 30 are more than 20");
}

}  // namespace
}  // namespace frontier_pilot
