#include "exploration/travel/coarse_space.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "exploration/tour/viewpoint_distances.h"
#include "frontier_pilot/core/grid_traversal.h"
#include "frontier_pilot/grids/cell_search.h"
#include "support/ascii_world.h"

namespace frontier_pilot {
namespace {

/// The number of the connected part that each cell belongs to, from 1; 0 where it is blocked.
Grid<int> partsOf(const Grid<std::uint8_t>& neighbours, const std::function<bool(Cell)>& passable) {
  Grid<int> parts(neighbours.geometry(), 0);
  int count = 0;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (parts[i] != 0 || !passable(parts.geometry().cell(i))) continue;
    parts[i] = ++count;
    std::vector<Cell> open{parts.geometry().cell(i)};
    while (!open.empty()) {
      const Cell cell = open.back();
      open.pop_back();
      for (unsigned d = 0; d < 8; ++d) {
        const Cell next{cell.x + grids::kNeighbourSteps[d].x, cell.y + grids::kNeighbourSteps[d].y};
        if ((neighbours[cell] >> d & 1U) == 0 || parts[next] != 0) continue;
        parts[next] = count;
        open.push_back(next);
      }
    }
  }
  return parts;
}

/// A hall with a wall as thin as the map can show it, at any angle, from one side to the other.
OccupancyGrid hallWithThinWall(double resolution, double angle, const Vec2& through) {
  GridGeometry geometry;
  geometry.resolution = resolution;
  geometry.width = geometry.height = static_cast<int>(4.0 / resolution);
  OccupancyGrid map(geometry, kFree);
  const Vec2 along = 8.0 * direction(angle);
  visitCells(geometry, through - along, through + along, [&](Cell c) {
    if (map.contains(c)) map[c] = kOccupied;
    return true;
  });
  return map;
}

// [EXP-9]
TEST(CoarseSpace, NeverLeadsThroughAThinWall_EXP_9) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  for (const double resolution : {0.025, 0.05, 0.075, 0.1, 0.2}) {
    for (int trial = 0; trial < 100; ++trial) {
      const double angle = trial < 20 ? kPi / 4.0 * trial : kPi * unit(random);
      const OccupancyGrid map = hallWithThinWall(resolution, angle, Vec2(1.5 + unit(random), 1.5 + unit(random)));
      exploration::TraversableSpace space(trial % 2 == 0 ? 0.134 : 0.164);
      space.update(map, map.geometry().rect());
      exploration::CoarseSpace coarse;
      coarse.update(space, map.geometry().rect());
      const Grid<int> fine = partsOf(space.neighbours(), [&](Cell c) { return space.traversable(c); });
      const Grid<int> parts = partsOf(coarse.neighbours(), [](Cell) { return true; });
      std::map<int, int> sides;
      for (std::size_t i = 0; i < fine.size(); ++i) {
        if (fine[i] == 0) continue;
        const int part = parts[coarse.geometry().cellAt(fine.geometry().centre(fine.geometry().cell(i)))];
        const int side = sides.emplace(part, fine[i]).first->second;
        ASSERT_EQ(side, fine[i]) << resolution << " m, angle " << angle << ", trial " << trial;
      }
    }
  }
}

// [EXP-9]
TEST(ViewpointDistances, KeepTheCoarseCellsOfBothSpacesOfTheEvaluator_EXP_9) {
  const test::AsciiWorld world = test::drawWorld("#????#\n#....#\n#.r..#\n#....#\n#....#\n######", 0.5);
  exploration::FrontierEvaluator evaluator{exploration::FrontierParameters{}, RobotModel{}.drivenOutline()};
  evaluator.setMap(world.map, world.map.geometry().rect());
  exploration::ViewpointDistances distances;
  exploration::FrontierEvaluator::Context context;
  context.robot = context.start = world.point('r');
  evaluator.evaluate(context);
  EXPECT_FALSE(distances.follow(evaluator).empty());
  evaluator.evaluateTightWays(context);
  EXPECT_FALSE(distances.follow(evaluator).empty());
  for (int i = 0; i < 2; ++i) {
    evaluator.evaluate(context);
    EXPECT_TRUE(distances.follow(evaluator).empty()) << "nothing has changed";
    evaluator.evaluateTightWays(context);
    EXPECT_TRUE(distances.follow(evaluator).empty()) << "nothing has changed";
  }
}

}  // namespace
}  // namespace frontier_pilot
