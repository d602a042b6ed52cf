#include "frontier_pilot/grids/distance_field.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <random>

namespace frontier_pilot {
namespace {

Grid<std::uint8_t> randomObstacles(int width, int height, double share, unsigned seed) {
  GridGeometry geometry;
  geometry.width = width;
  geometry.height = height;
  Grid<std::uint8_t> out(geometry);
  std::mt19937 random(seed);
  std::bernoulli_distribution solid(share);
  for (std::uint8_t& cell : out.cells()) cell = solid(random) ? 1 : 0;
  return out;
}

double bruteForce(const Grid<std::uint8_t>& obstacle, Cell c, double max_distance) {
  double nearest = max_distance;
  for (std::size_t i = 0; i < obstacle.size(); ++i) {
    if (obstacle[i] == 0) continue;
    const Cell o = obstacle.geometry().cell(i);
    nearest = std::min(nearest, std::hypot(o.x - c.x, o.y - c.y) * obstacle.resolution());
  }
  return nearest;
}

void expectExact(const grids::DistanceField& field, const Grid<std::uint8_t>& obstacle) {
  for (std::size_t i = 0; i < obstacle.size(); ++i) {
    const Cell c = obstacle.geometry().cell(i);
    ASSERT_NEAR(field[c], bruteForce(obstacle, c, field.maxDistance()), 1e-5) << c.x << " " << c.y;
  }
}

TEST(DistanceField, EqualsTheBruteForceSearch) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    for (const double max_distance : {0.12, 0.5, 1e3}) {
      const auto obstacle = randomObstacles(37, 23, seed < 10 ? 0.01 : 0.2, seed);
      expectExact(grids::DistanceField(obstacle, max_distance), obstacle);
    }
  }
}

TEST(DistanceField, IsTheMaximumWhereNothingIs) {
  const auto obstacle = randomObstacles(8, 5, 0.0, 0);
  const grids::DistanceField field(obstacle, 0.7);
  EXPECT_TRUE(std::all_of(field.grid().cells().begin(), field.grid().cells().end(), [](float d) { return d == 0.7F; }));
  EXPECT_EQ(field.at(Cell{-1, 0}), 0.0);
}

TEST(DistanceField, AnUpdateOfTheChangedBlockEqualsComputingAnew) {
  std::mt19937 random(3);
  auto obstacle = randomObstacles(80, 60, 0.02, 5);
  grids::DistanceField field(obstacle, 0.6);
  for (int step = 0; step < 30; ++step) {
    const CellRect changed{static_cast<int>(random() % 70), static_cast<int>(random() % 50), 10, 10};
    for (int k = 0; k < 5; ++k) {
      const Cell c{changed.x + static_cast<int>(random() % 10), changed.y + static_cast<int>(random() % 10)};
      obstacle[c] = static_cast<std::uint8_t>(1 - obstacle[c]);
    }
    field.update(obstacle, changed);
    ASSERT_EQ(field.grid().cells(), grids::DistanceField(obstacle, 0.6).grid().cells());
  }
}

// [SIM-3] Robots drove through the walls of a world wider than 46,340 cells, the square of which is no 32-bit number.
TEST(DistanceField, IsExactAtBothEndsOfAWideGrid_SIM_3) {
  auto obstacle = randomObstacles(50000, 3, 0.0, 0);
  obstacle[Cell{100, 1}] = 1;
  obstacle[Cell{49900, 1}] = 1;
  const grids::DistanceField field(obstacle, 2.0);
  for (int x = 0; x < obstacle.width(); ++x) {
    const int cells = std::min(std::abs(x - 100), std::abs(x - 49900));
    ASSERT_NEAR(field.at(Cell{x, 1}), std::min(cells * obstacle.resolution(), 2.0), 1e-5) << x;
  }
}

// [SIM-3]
TEST(DistanceField, IsExactFarFromTheOnlyObstacleOfAWideGrid_SIM_3) {
  auto obstacle = randomObstacles(50000, 3, 0.0, 0);
  obstacle[Cell{0, 1}] = 1;
  const grids::DistanceField field(obstacle, 1e6);
  for (int x = 0; x < obstacle.width(); ++x) ASSERT_NEAR(field.at(Cell{x, 1}), x * obstacle.resolution(), 1e-3) << x;
}

TEST(DistanceField, RefusesAMaximumOfZeroAndAnotherGeometry) {
  auto obstacle = randomObstacles(8, 5, 0.1, 0);
  EXPECT_THROW(grids::DistanceField(obstacle, 0.0), std::invalid_argument);
  grids::DistanceField field(obstacle, 1.0);
  EXPECT_THROW(field.update(randomObstacles(9, 5, 0.1, 0), {0, 0, 1, 1}), std::invalid_argument);
}

}  // namespace
}  // namespace frontier_pilot
