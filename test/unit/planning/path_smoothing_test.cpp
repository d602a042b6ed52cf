#include "planning/path_smoothing.h"

#include <gtest/gtest.h>

#include <random>

#include "planning/grid_search.h"
#include "support/ascii_world.h"
#include "support/floors/open_floor.h"

namespace frontier_pilot {
namespace {

using test::clearanceOf;

double costOf(const planning::ClearanceMap& map, const planning::Path& path) {
  double cost = 0.0;
  for (std::size_t i = 0; i + 1 < path.points().size(); ++i) {
    const double step = map.segmentCost(path.points()[i], path.points()[i + 1]);
    EXPECT_GE(step, 0.0) << "segment " << i << " is not valid";
    cost += step;
  }
  return cost;
}

planning::Path gridPath(const planning::ClearanceMap& map, Cell start, Cell goal) {
  planning::GridSearch search;
  if (!search.search(map, start, goal)) return {};
  std::vector<Vec2> points;
  for (const Cell cell : search.pathTo(goal)) points.push_back(map.geometry().centre(cell));
  return planning::Path(points);
}

planning::ClearanceMap openFloor() {
  return clearanceOf(OccupancyGrid(GridGeometry{0.05, Vec2::Zero(), 60, 60}, kFree));
}

TEST(PathSmoothing, LeavesPathsWithoutACornerAsTheyAre) {
  const planning::ClearanceMap map = openFloor();
  EXPECT_TRUE(planning::smoothPath(map, planning::Path()).empty());
  EXPECT_TRUE(planning::pullString(map, {}).empty());
  const planning::Path point({{1.0, 1.0}});
  EXPECT_EQ(planning::smoothPath(map, point).points(), point.points());
  const planning::Path line({{1.0, 1.0}, {2.0, 1.5}});
  EXPECT_EQ(planning::smoothPath(map, line).points(), line.points());
}

TEST(PathSmoothing, PullsADetourInTheOpenStraight) {
  const planning::ClearanceMap map = openFloor();
  const planning::Path smooth =
      planning::smoothPath(map, planning::Path({{0.5, 0.5}, {1.5, 0.5}, {1.5, 2.0}, {2.5, 2.0}}));
  EXPECT_EQ(smooth.points(), (std::vector<Vec2>{{0.5, 0.5}, {2.5, 2.0}}));
}

TEST(PathSmoothing, DropsSamplesThatLieOnALine) {
  EXPECT_EQ(planning::pullString(openFloor(), {{0.5, 1.0}, {1.0, 1.0}, {1.5, 1.0}, {2.0, 1.0}}).points().size(), 2U);
}

TEST(PathSmoothing, GivesTheSamplesWhereEachIsNeeded) {
  const auto world = test::drawWorld(R"(
    ..............................
    ..............................
    ..............................
    .....A...............B........
    ..............................
    ..............................
    ..............................
    ..........#########...........
    ..........#########...........
    ..........#########...........
    ..........#########...........
    .....S....#########..G........
    ..............................
  )");
  planning::ClearanceParams params;
  params.wall_weight = 0.0;
  const planning::ClearanceMap map = clearanceOf(world.map, params);
  const std::vector<Vec2> samples{world.point('S'), world.point('A'), world.point('B'), world.point('G')};
  EXPECT_EQ(planning::pullString(map, samples).points(), samples);
}

TEST(PathSmoothing, KeepsEndsAndValidityAndNeverMakesAPathLonger) {
  std::mt19937 random(6);
  int smoothed = 0;
  for (int round = 0; round < 60; ++round) {
    OccupancyGrid grid(GridGeometry{0.05, Vec2(-1.0, 1.0), 50, 50}, kFree);
    for (int i = 0; i < 25; ++i) grid[random() % grid.size()] = kOccupied;
    const planning::ClearanceMap map = clearanceOf(grid);
    const Cell start = grid.geometry().cell(random() % grid.size());
    const Cell goal = grid.geometry().cell(random() % grid.size());
    if (!map.isPassable(start) || !map.isPassable(goal)) continue;
    const planning::Path path = gridPath(map, start, goal);
    if (path.empty()) continue;
    const planning::Path smooth = planning::smoothPath(map, path);
    ASSERT_EQ(smooth.points().front(), path.points().front());
    ASSERT_EQ(smooth.goal(), path.goal());
    EXPECT_GE(costOf(map, smooth), smooth.length() - 1e-9);
    EXPECT_LE(smooth.length(), path.length() + 1e-9) << "round " << round;
    ++smoothed;
  }
  EXPECT_GT(smoothed, 10);
}

}  // namespace
}  // namespace frontier_pilot
