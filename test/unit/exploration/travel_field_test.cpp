#include "exploration/travel/travel_field.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <random>

#include "support/ascii_world.h"

namespace frontier_pilot {
namespace {

constexpr double kResolution = 0.05;

bool isTraversable(const OccupancyGrid& map, Cell c, double clearance) {
  if (!isFree(map[c])) return false;
  for (std::size_t i = 0; i < map.size(); ++i) {
    const Cell o = map.geometry().cell(i);
    if (isOccupied(map[i]) && std::hypot(o.x - c.x, o.y - c.y) * kResolution < clearance - 1e-9) return false;
  }
  return true;
}

/// Dijkstra over all eight neighbours, in units of a fifth of a cell.
std::vector<int> dijkstra(const OccupancyGrid& map, const exploration::TraversableSpace& space, Cell start) {
  constexpr int kFar = std::numeric_limits<int>::max();
  std::vector<int> cost(map.size(), kFar);
  using Entry = std::pair<int, std::size_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  cost[map.geometry().index(start)] = 0;
  queue.push({0, map.geometry().index(start)});
  while (!queue.empty()) {
    const auto [units, index] = queue.top();
    queue.pop();
    if (units != cost[index]) continue;
    const Cell c = map.geometry().cell(index);
    for (int d = 0; d < 9; ++d) {
      const Cell next{c.x + d % 3 - 1, c.y + d / 3 - 1};
      if (!space.traversable(next) || next == c) continue;
      const int reach = units + (next.x != c.x && next.y != c.y ? 7 : 5);
      if (reach >= cost[map.geometry().index(next)]) continue;
      cost[map.geometry().index(next)] = reach;
      queue.push({reach, map.geometry().index(next)});
    }
  }
  return cost;
}

OccupancyGrid clutter(unsigned seed, int width, int height, unsigned one_in) {
  std::mt19937 random(seed);
  GridGeometry geometry;
  geometry.width = width;
  geometry.height = height;
  OccupancyGrid map(geometry, kFree);
  for (auto& cell : map.cells()) {
    if (random() % one_in == 0) cell = random() % 3 == 0 ? kUnknown : kOccupied;
  }
  return map;
}

TEST(TraversableSpace, KeepsTheClearanceFromOccupiedCellsAndStaysOnKnownGround) {
  for (const double clearance : {0.0, 0.05, 0.07, 0.15, 0.21}) {
    const OccupancyGrid map = clutter(5, 40, 30, 60);
    exploration::TraversableSpace space(clearance);
    space.update(map, map.geometry().rect());
    for (std::size_t i = 0; i < map.size(); ++i) {
      const Cell c = map.geometry().cell(i);
      ASSERT_EQ(space.traversable(c), isTraversable(map, c, clearance)) << c.x << " " << c.y << " " << clearance;
    }
  }
}

TEST(TraversableSpace, AnUpdateOfABlockGivesWhatTheWholeMapGives) {
  std::mt19937 random(2);
  OccupancyGrid map = clutter(1, 70, 50, 50);
  exploration::TraversableSpace space(0.15);
  space.update(map, map.geometry().rect());
  for (int i = 0; i < 60; ++i) {
    const CellRect block =
        CellRect{static_cast<int>(random() % 75) - 5, static_cast<int>(random() % 55) - 5, 6, 4}.intersection(
            map.geometry().rect());
    const auto value = static_cast<std::int8_t>(random() % 2 == 0 ? kFree : (random() % 2 == 0 ? kUnknown : kOccupied));
    for (int y = block.y; y < block.y + block.height; ++y) std::fill_n(map.row(y) + block.x, block.width, value);
    space.update(map, block);
    exploration::TraversableSpace fresh(0.15);
    fresh.update(map, map.geometry().rect());
    ASSERT_EQ(space.neighbours().cells(), fresh.neighbours().cells()) << "change " << i;
  }
}

TEST(TravelField, GivesTheDistancesOfDijkstra) {
  for (unsigned seed = 0; seed < 120; ++seed) {
    const unsigned one_in = seed % 4 == 0 ? 150 : 2 + seed % 11;  // open ground, where the wave runs ahead, or a maze
    const OccupancyGrid map = clutter(seed, 20 + static_cast<int>(seed), 45, one_in);
    exploration::TraversableSpace space(0.0);
    space.update(map, map.geometry().rect());
    Cell start{7, 22};
    while (!space.traversable(start)) ++start.x;
    exploration::TravelField field;
    field.compute(space, map, start, 0.5);
    const std::vector<int> expected = dijkstra(map, space, start);
    for (std::size_t i = 0; i < map.size(); ++i) {
      const Cell c = map.geometry().cell(i);
      if (expected[i] == std::numeric_limits<int>::max()) {
        ASSERT_FALSE(field.reached(c)) << "seed " << seed;
      } else {
        ASSERT_NEAR(field.distance(c), expected[i] * kResolution / 5, 1e-9)
            << "seed " << seed << " " << c.x << " " << c.y;
      }
    }
  }
}

TEST(TravelField, AWallMakesTheWayLongerThanTheStraightLine_EXP_4) {
  const auto world = test::drawWorld(R"(
    ###########
    #....#....#
    #.a..#..b.#
    #....#....#
    #.........#
    ###########
  )");
  exploration::TraversableSpace space(0.05);
  space.update(world.map, world.map.geometry().rect());
  exploration::TravelField field;
  field.compute(space, world.map, world.cell('a'), 0.5);
  // [EXP-4]: the travel distance, not the Euclidean one of 6 cells.
  EXPECT_NEAR(field.distance(world.cell('b')), (2 * 5 + 4 * 7) * 0.01, 1e-9);
}

TEST(TravelField, ARobotInsideTheInflationGetsOut) {
  const auto world = test::drawWorld(R"(
    ############
    #r.........#
    #..........#
    #..........#
    #..........#
    #..........#
    #..........#
    ############
  )");
  exploration::TraversableSpace space(0.15);
  space.update(world.map, world.map.geometry().rect());
  ASSERT_FALSE(space.traversable(world.cell('r')));
  exploration::TravelField field;
  field.compute(space, world.map, world.cell('r'), 0.5);
  EXPECT_TRUE(field.reached({5, 3}));
  field.compute(space, world.map, world.cell('r'), 0.05);
  EXPECT_EQ(field.reachedCount(), 0U);
}

TEST(TravelField, ARobotOutsideOfTheMapReachesNothing) {
  const auto world = test::drawWorld("....\n....");
  exploration::TraversableSpace space(0.0);
  space.update(world.map, world.map.geometry().rect());
  exploration::TravelField field;
  field.compute(space, world.map, {-3, 9}, 0.5);
  EXPECT_EQ(field.reachedCount(), 0U);
  EXPECT_TRUE(std::isinf(field.distance({1, 1})));
}

// [EXP-9]
TEST(TravelFieldOverMasks, IsExactWithinTheDistanceAskedForAndForgetsTheOneBefore_EXP_9) {
  std::mt19937 random(7);
  GridGeometry geometry;
  geometry.width = 80;
  geometry.height = 60;
  OccupancyGrid map(geometry, kFree);
  for (auto& cell : map.cells()) cell = random() % 5 == 0 ? kOccupied : kFree;
  exploration::TraversableSpace space(0.0);
  space.update(map, map.geometry().rect());
  exploration::TravelField whole;
  exploration::TravelField bounded;
  constexpr double kFarthest = 1.5;
  for (const Cell start : {Cell{5, 5}, Cell{40, 30}, Cell{79, 59}}) {
    map[start] = kFree;
    space.update(map, CellRect{start.x, start.y, 1, 1});
    whole.compute(space, map, start, 0.0);
    bounded.compute(space.neighbours(), start, kFarthest);
    for (std::size_t i = 0; i < map.size(); ++i) {
      const Cell cell = geometry.cell(i);
      if (whole.distance(cell) <= kFarthest && cell != start) {
        EXPECT_DOUBLE_EQ(bounded.distance(cell), whole.distance(cell)) << cell.x << ", " << cell.y;
      }
      if (!whole.reached(cell)) {
        EXPECT_FALSE(bounded.reached(cell));
      }
    }
  }
}

// [EXP-9]
TEST(TravelFieldOverMasks, IsExactAtTheTargetsAndDoesNotGoOnBeyondThem_EXP_9) {
  exploration::TraversableSpace space(0.0);
  exploration::TravelField whole;
  exploration::TravelField aimed;
  constexpr double kAnywhere = 100.0;
  for (unsigned seed = 1; seed <= 5; ++seed) {
    OccupancyGrid map = clutter(seed, 120, 90, 5);
    const Cell start{10, 10};
    map[start] = kFree;
    space.update(map, map.geometry().rect());
    whole.compute(space.neighbours(), start, kAnywhere);
    for (const std::vector<Cell>& targets : {std::vector<Cell>{{30, 12}}, {{12, 30}, {20, 20}, {5, 5}}, {}}) {
      aimed.compute(space.neighbours(), start, kAnywhere, targets);
      bool all = true;
      for (const Cell target : targets) {
        EXPECT_EQ(aimed.distance(target), whole.distance(target)) << "seed " << seed;
        all = all && whole.reached(target);
      }
      if (all) {
        EXPECT_LT(aimed.reachedCount(), whole.reachedCount() / 2) << "seed " << seed;
      }
    }
  }
}

}  // namespace
}  // namespace frontier_pilot
