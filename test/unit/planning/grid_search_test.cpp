#include "planning/grid_search.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <random>
#include <set>
#include <tuple>

#include "support/ascii_world.h"
#include "support/floors/open_floor.h"

namespace frontier_pilot {
namespace {

using test::clearanceOf;
using test::drawWorld;
using test::pointRobot;

OccupancyGrid worldOfSingleWalls(std::mt19937& random, int side, unsigned one_wall_in) {
  OccupancyGrid map(GridGeometry{0.05, Vec2::Zero(), side, side}, kFree);
  for (std::int8_t& cell : map.cells()) cell = random() % one_wall_in == 0 ? kOccupied : kFree;
  return map;
}

bool isStep(const planning::ClearanceMap& map, Cell from, Cell to) {
  const int dx = std::abs(to.x - from.x);
  const int dy = std::abs(to.y - from.y);
  if (std::max(dx, dy) != 1 || !map.isPassable(to)) return false;
  return map.isPassable({to.x, from.y}) && map.isPassable({from.x, to.y});
}

double stepCost(const planning::ClearanceMap& map, Cell from, Cell to) {
  const double length = from.x != to.x && from.y != to.y ? 99.0 : 70.0;
  return std::round(length * map.weight(map.costClass(to)));
}

double costOf(const planning::ClearanceMap& map, const std::vector<Cell>& path) {
  double cost = 0.0;
  for (std::size_t i = 0; i + 1 < path.size(); ++i) cost += stepCost(map, path[i], path[i + 1]);
  return cost;
}

/// What the cheapest path costs by Dijkstra's search over the same steps; negative if there is none.
double leastCost(const planning::ClearanceMap& map, Cell start, Cell goal) {
  Grid<double> costs(map.geometry(), 1e18);
  std::set<std::tuple<double, int, int>> open{{0.0, start.x, start.y}};
  costs[start] = 0.0;
  while (!open.empty()) {
    const auto [cost, x, y] = *open.begin();
    open.erase(open.begin());
    if (Cell{x, y} == goal) return cost;
    for (int i = 0; i < 9; ++i) {
      const Cell next{x + i % 3 - 1, y + i / 3 - 1};
      if (!isStep(map, {x, y}, next)) continue;
      const double sum = cost + stepCost(map, {x, y}, next);
      if (sum >= costs[next]) continue;
      costs[next] = sum;
      open.insert({sum, next.x, next.y});
    }
  }
  return -1.0;
}

TEST(GridSearch, FindsThePathOfOneCellWhereTheStartIsTheGoal) {
  const planning::ClearanceMap map = clearanceOf(drawWorld(".").map, pointRobot());
  planning::GridSearch search;
  ASSERT_TRUE(search.search(map, {0, 0}, {0, 0}));
  EXPECT_EQ(search.pathTo({0, 0}), (std::vector<Cell>{{0, 0}}));
  EXPECT_EQ(search.expanded(), 1U);
}

TEST(GridSearch, HasReachedNothingBeforeItSearchedNorOutsideOfTheMap) {
  planning::GridSearch search;
  EXPECT_FALSE(search.reached({0, 0}));
  ASSERT_TRUE(search.search(clearanceOf(drawWorld("...").map, pointRobot()), {0, 0}, {2, 0}));
  EXPECT_FALSE(search.reached({-1, 0}));
  EXPECT_FALSE(search.reached({3, 0}));
  EXPECT_FALSE(search.reached({0, 1}));
}

TEST(GridSearch, LooksAtNothingBesideAStraightLineInTheOpen) {
  const planning::ClearanceMap map =
      clearanceOf(OccupancyGrid(GridGeometry{0.05, Vec2::Zero(), 30, 30}, kFree), pointRobot());
  planning::GridSearch search;
  ASSERT_TRUE(search.search(map, {2, 15}, {27, 15}));
  EXPECT_EQ(search.pathTo({27, 15}).size(), 26U);
  EXPECT_EQ(search.expanded(), 26U);
}

TEST(GridSearch, KnowsAllThatIsReachableWhereThereIsNoPath) {
  const auto world = drawWorld(R"(
    .....#...
    .S...#.G.
    .....#...
  )");
  const planning::ClearanceMap map = clearanceOf(world.map, pointRobot());
  planning::GridSearch search;
  ASSERT_FALSE(search.search(map, world.cell('S'), world.cell('G')));
  EXPECT_EQ(search.expanded(), 15U);
  for (std::size_t i = 0; i < world.map.size(); ++i) {
    const Cell cell = world.map.geometry().cell(i);
    EXPECT_EQ(search.reached(cell), cell.x < 5) << cell.x << ", " << cell.y;
  }
}

TEST(GridSearch, PassesNoCornerThatADiagonalStepWouldCut) {
  const auto closed = drawWorld(R"(
    ..#G
    S.##
    ....
  )");
  planning::GridSearch search;
  EXPECT_FALSE(search.search(clearanceOf(closed.map, pointRobot()), closed.cell('S'), closed.cell('G')));
  const auto corner = drawWorld(R"(
    .G
    S#
  )");
  ASSERT_TRUE(search.search(clearanceOf(corner.map, pointRobot()), corner.cell('S'), corner.cell('G')));
  EXPECT_EQ(search.pathTo(corner.cell('G')).size(), 3U) << "around, not across";
}

TEST(GridSearch, PrefersTheLongerWayWhereTheShorterOneRunsAlongWalls) {
  const auto world = drawWorld(R"(
    ....................
    ....................
    ....................
    ....................
    ....................
    ....................
    S..................G
    ....................
    ....................
    ####################
  )");
  planning::ClearanceParams params = pointRobot();
  params.preferred_clearance = 0.4;
  params.wall_weight = 3.0;
  const planning::ClearanceMap map = clearanceOf(world.map, params);
  planning::GridSearch search;
  ASSERT_TRUE(search.search(map, world.cell('S'), world.cell('G')));
  int highest = 0;
  for (const Cell cell : search.pathTo(world.cell('G'))) highest = std::max(highest, cell.y);
  EXPECT_GT(highest, world.cell('S').y);
}

TEST(GridSearch, FindsTheCheapestPathWheneverThereIsOne) {
  std::mt19937 random(1);
  planning::GridSearch search;
  int found = 0;
  for (int round = 0; round < 200; ++round) {
    planning::ClearanceParams params = pointRobot();
    params.preferred_clearance = 0.2;
    params.wall_weight = 0.5 * (round % 7);
    const planning::ClearanceMap map = clearanceOf(worldOfSingleWalls(random, 25, 3 + round % 8), params);
    const Cell start = map.geometry().cell(random() % map.geometry().size());
    const Cell goal = map.geometry().cell(random() % map.geometry().size());
    if (!map.isPassable(start) || !map.isPassable(goal)) continue;
    const double least = leastCost(map, start, goal);
    ASSERT_EQ(search.search(map, start, goal), least >= 0.0);
    if (least < 0.0) continue;
    const std::vector<Cell> path = search.pathTo(goal);
    ASSERT_EQ(path.front(), start);
    ASSERT_EQ(path.back(), goal);
    for (std::size_t i = 0; i + 1 < path.size(); ++i) ASSERT_TRUE(isStep(map, path[i], path[i + 1]));
    ASSERT_DOUBLE_EQ(costOf(map, path), least);
    ++found;
  }
  EXPECT_GT(found, 50);
}

TEST(GridSearch, AnswersTheSameWhateverItSearchedBefore) {
  std::mt19937 random(2);
  planning::GridSearch used;
  for (int round = 0; round < 30; ++round) {
    const planning::ClearanceMap map = clearanceOf(worldOfSingleWalls(random, 10 + round % 3, 6), pointRobot());
    const Cell start = map.geometry().cell(random() % map.geometry().size());
    const Cell goal = map.geometry().cell(random() % map.geometry().size());
    if (!map.isPassable(start) || !map.isPassable(goal)) continue;
    planning::GridSearch fresh;
    const bool found = fresh.search(map, start, goal);
    ASSERT_EQ(used.search(map, start, goal), found);
    ASSERT_EQ(used.expanded(), fresh.expanded());
    if (found) {
      ASSERT_EQ(used.pathTo(goal), fresh.pathTo(goal));
    }
  }
}

}  // namespace
}  // namespace frontier_pilot
