#include "frontier_pilot/planning/clearance_map.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "support/ascii_world.h"

namespace frontier_pilot {
namespace {

OccupancyGrid randomWorld(std::mt19937& random, int size, int obstacles) {
  OccupancyGrid map(GridGeometry{0.05, Vec2(-1.0, 2.0), size, size}, kFree);
  for (int i = 0; i < obstacles; ++i) map[random() % map.size()] = random() % 4 == 0 ? kUnknown : kOccupied;
  return map;
}

/// Distance from `point` to the nearest occupied cell, a full square [m].
double distanceToObstacles(const OccupancyGrid& map, const Vec2& point) {
  double least = 1e9;
  for (std::size_t i = 0; i < map.size(); ++i) {
    if (!isOccupied(map[i])) continue;
    const Vec2 off = (point - map.geometry().centre(map.geometry().cell(i))).cwiseAbs();
    least = std::min(least, (off.array() - 0.5 * map.resolution()).max(0.0).matrix().norm());
  }
  return least;
}

// [NAV-4] The rule for the raster of the distance field: no valid point lets the footprint touch an obstacle.
TEST(ClearanceMap, KeepsTheFootprintOffEveryObstacleCell_NAV_4) {
  std::mt19937 random(1);
  for (int round = 0; round < 20; ++round) {
    const OccupancyGrid map = randomWorld(random, 40, 25);
    planning::ClearanceParams params;
    params.tight_weight = 0.0;
    planning::ClearanceMap clearance(params);
    clearance.setMap(map, map.geometry().rect());
    std::uniform_real_distribution<double> x(-1.0, 1.0);
    std::uniform_real_distribution<double> y(2.0, 4.0);
    for (int i = 0; i < 500; ++i) {
      const Vec2 from(x(random), y(random));
      const Vec2 to(x(random), y(random));
      if (!clearance.isValid(from, to)) continue;
      for (double t = 0.0; t <= 1.0; t += 0.02) {
        EXPECT_GT(distanceToObstacles(map, from + t * (to - from)), clearance.params().inscribed_radius);
      }
    }
  }
}

TEST(ClearanceMap, TakesATightPlaceOnlyAsTheLastResort_NAV_2) {
  // Two corners, each drawn a cell too thick, leave 2.83 cells diagonally.
  OccupancyGrid map(GridGeometry{0.05, Vec2::Zero(), 40, 40}, kFree);
  for (int i = 0; i < 40; ++i) {
    if (i <= 18) map[Cell{i, 18}] = kOccupied;
    if (i >= 22) map[Cell{i, 22}] = kOccupied;
  }
  planning::ClearanceMap clearance;
  clearance.setMap(map, map.geometry().rect());
  EXPECT_TRUE(clearance.isPassable({20, 20}));
  EXPECT_EQ(clearance.costClass({20, 20}), planning::ClearanceMap::kTightClass);
  EXPECT_NEAR(clearance.segmentCost({1.024, 1.025}, {1.026, 1.025}), 0.002 * clearance.params().tight_weight, 1e-9);
  planning::ClearanceParams params;
  params.tight_weight = 0.0;
  planning::ClearanceMap strict(params);
  strict.setMap(map, map.geometry().rect());
  EXPECT_FALSE(strict.isPassable({20, 20}));
}

TEST(ClearanceMap, LetsThroughWhatADiscOf15CentimetresReaches_NAV_2) {
  // Cells whose centres are more than three cells from every obstacle's are reachable floor for such a disc.
  std::mt19937 random(2);
  const OccupancyGrid map = randomWorld(random, 60, 30);
  planning::ClearanceMap clearance;
  clearance.setMap(map, map.geometry().rect());
  int counted = 0;
  for (std::size_t i = 0; i < map.size(); ++i) {
    const Cell cell = map.geometry().cell(i);
    if (!isFree(map[i]) || clearance.field()[cell] <= 0.1501F) continue;
    EXPECT_TRUE(clearance.isPassable(cell));
    ++counted;
  }
  EXPECT_GT(counted, 100);
}

TEST(ClearanceMap, UpdatedPieceByPieceIsTheSameAsMadeAnew_NAV_2) {
  std::mt19937 random(3);
  OccupancyGrid map = randomWorld(random, 70, 60);
  planning::ClearanceMap updated;
  updated.setMap(map, map.geometry().rect());
  for (int round = 0; round < 30; ++round) {
    CellRect changed;
    for (int i = 0; i < 5; ++i) {
      const Cell cell = map.geometry().cell(random() % map.size());
      map[cell] = static_cast<std::int8_t>(static_cast<int>(random() % 3) * 50 - 1);
      changed.include(cell);
    }
    updated.setMap(map, changed);
    const Cell live = map.geometry().cell(random() % map.size());
    updated.setLive(live, true);
    if (round % 2 == 0) updated.refresh();
    updated.setLive(live, false);
    updated.refresh();
    planning::ClearanceMap fresh;
    fresh.setMap(map, map.geometry().rect());
    ASSERT_EQ(updated.costs().cells(), fresh.costs().cells()) << "round " << round;
  }
}

TEST(ClearanceMap, PricesASegmentExactlyUpToTheLimit) {
  std::mt19937 random(5);
  OccupancyGrid grid(GridGeometry{0.05, Vec2(-1.0, 1.0), 50, 50}, kFree);
  for (int i = 0; i < 20; ++i) grid[random() % grid.size()] = kOccupied;
  planning::ClearanceMap map;
  map.setMap(grid, grid.geometry().rect());
  int valid = 0;
  for (int i = 0; i < 500; ++i) {
    const Vec2 from = grid.geometry().centre(grid.geometry().cell(random() % grid.size()));
    const Vec2 to = grid.geometry().centre(grid.geometry().cell(random() % grid.size()));
    const double cost = map.segmentCost(from, to);
    if (cost < 0.0) continue;
    EXPECT_DOUBLE_EQ(map.segmentCost(from, to, cost + 1e-6), cost);
    EXPECT_GT(map.segmentCost(from, to, 0.9 * cost), 0.9 * cost);
    ++valid;
  }
  EXPECT_GT(valid, 50);
}

TEST(ClearanceMap, LeadsNoPathThroughUnknownCellsUnlessTold_NAV_2) {
  const auto world = test::drawWorld(std::string(20, '.') + "\n" + std::string(20, '?') + "\n" + std::string(20, '.'));
  planning::ClearanceMap strict;
  strict.setMap(world.map, world.map.geometry().rect());
  EXPECT_FALSE(strict.isValid({0.5, 0.02}, {0.5, 0.13}));
  EXPECT_TRUE(strict.isValid({0.5, 0.02}, {0.7, 0.02}));
  planning::ClearanceParams params;
  params.unknown_is_traversable = true;
  planning::ClearanceMap bold(params);
  bold.setMap(world.map, world.map.geometry().rect());
  EXPECT_TRUE(bold.isValid({0.5, 0.02}, {0.5, 0.13}));
}

TEST(ClearanceMap, WithOtherParametersIsTheMapThatWouldHaveBeenMadeWithThem) {
  std::mt19937 random(5);
  for (const double preferred : {0.0, 0.2, 0.8}) {
    for (const bool unknown : {false, true}) {
      const OccupancyGrid map = randomWorld(random, 60, 40);
      planning::ClearanceMap changed;
      changed.setMap(map, map.geometry().rect());
      changed.setLive({30, 30}, true);
      planning::ClearanceParams params;
      params.preferred_clearance = preferred;
      params.unknown_is_traversable = unknown;
      EXPECT_TRUE(changed.setParams(params));
      EXPECT_FALSE(changed.setParams(params)) << "nothing differs";
      planning::ClearanceMap made(params);
      made.setMap(map, map.geometry().rect());
      made.setLive({30, 30}, true);
      made.refresh();
      EXPECT_EQ(changed.costs().cells(), made.costs().cells()) << preferred << " m, unknown " << unknown;
    }
  }
}

}  // namespace
}  // namespace frontier_pilot
