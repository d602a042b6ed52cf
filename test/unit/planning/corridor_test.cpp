#include "planning/corridor.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "planning/grid_search.h"
#include "support/floors/open_floor.h"

namespace frontier_pilot {
namespace {

using test::clearanceOf;
using test::pointRobot;

/// Rooms of 16 cells with a door in each wall, in a random place.
OccupancyGrid rooms(std::mt19937& random, int side) {
  OccupancyGrid map(GridGeometry{0.05, Vec2::Zero(), side, side}, kFree);
  for (int wall = 16; wall < side; wall += 16) {
    for (int i = 0; i < side; ++i) map[Cell{wall, i}] = map[Cell{i, wall}] = kOccupied;
  }
  for (int wall = 16; wall < side; wall += 16) {
    for (int room = 0; room < side; room += 16) {
      const int door = room + 1 + static_cast<int>(random() % 10);
      for (int i = door; i < std::min(side, door + 5); ++i) {
        map[Cell{wall, i}] = kFree;
        map[Cell{i, wall}] = kFree;
      }
    }
  }
  return map;
}

std::size_t cellsIn(const Grid<std::uint8_t>& classes) {
  std::size_t count = 0;
  for (const std::uint8_t cost_class : classes.cells()) count += cost_class != 0 ? 1 : 0;
  return count;
}

TEST(Corridor, LeavesOutWhatIsFarFromTheWay) {
  const planning::ClearanceMap map =
      clearanceOf(OccupancyGrid(GridGeometry{0.05, Vec2::Zero(), 100, 100}, kFree), pointRobot());
  planning::Corridor corridor;
  ASSERT_TRUE(corridor.find(map, {5, 50}, {95, 50}));
  EXPECT_EQ(corridor.classes()[Cell({50, 50})], map.costClass({50, 50}));
  EXPECT_EQ(corridor.classes()[Cell({50, 90})], 0);
  EXPECT_LT(cellsIn(corridor.classes()), 2500U);
}

TEST(Corridor, ContainsAPathThatIsHardlyDearerThanTheCheapest) {
  std::mt19937 random(3);
  planning::Corridor corridor;
  planning::GridSearch search;
  int found = 0;
  for (int round = 0; round < 120; ++round) {
    const planning::ClearanceMap map = clearanceOf(rooms(random, 130 + round % 4));
    const Cell start = map.geometry().cell(random() % map.geometry().size());
    const Cell goal = map.geometry().cell(random() % map.geometry().size());
    if (!map.isPassable(start) || !map.isPassable(goal)) continue;
    if (!search.search(map, start, goal)) continue;
    const std::uint32_t least = search.costTo(goal);
    ASSERT_TRUE(corridor.find(map, start, goal));
    ASSERT_TRUE(search.search(map, corridor.classes(), start, goal)) << "round " << round;
    EXPECT_LE(search.costTo(goal), least + least / 50) << "round " << round;
    ++found;
  }
  EXPECT_GT(found, 20);
}

TEST(Corridor, ContainsEverythingThatAGreaterBoundAllows) {
  const planning::ClearanceMap map =
      clearanceOf(OccupancyGrid(GridGeometry{0.05, Vec2::Zero(), 100, 100}, kFree), pointRobot());
  planning::Corridor corridor;
  ASSERT_TRUE(corridor.find(map, {5, 50}, {95, 50}, 1'000'000));
  EXPECT_GE(corridor.bound(), 999'000U);
  EXPECT_EQ(cellsIn(corridor.classes()), map.geometry().size());
}

TEST(Corridor, LinksNoBlocksThatAnUnknownStripDivides) {
  for (int strip = 3; strip < 8; ++strip) {
    OccupancyGrid map(GridGeometry{0.05, Vec2::Zero(), 11, 4}, kFree);
    for (int y = 0; y < 4; ++y) map[Cell{strip, y}] = kUnknown;
    planning::Corridor corridor;
    EXPECT_FALSE(corridor.find(clearanceOf(map, pointRobot()), {1, 1}, {9, 1})) << strip;
  }
}

TEST(Corridor, IsTheSameWhateverWasSoughtBefore) {
  std::mt19937 random(4);
  planning::Corridor used;
  for (int round = 0; round < 20; ++round) {
    const planning::ClearanceMap map = clearanceOf(rooms(random, 60 + round % 3));
    const Cell start = map.geometry().cell(random() % map.geometry().size());
    const Cell goal = map.geometry().cell(random() % map.geometry().size());
    if (!map.isPassable(start) || !map.isPassable(goal)) continue;
    planning::Corridor fresh;
    const bool found = fresh.find(map, start, goal);
    ASSERT_EQ(used.find(map, start, goal), found);
    ASSERT_EQ(used.classes().cells(), fresh.classes().cells());
  }
}

}  // namespace
}  // namespace frontier_pilot
