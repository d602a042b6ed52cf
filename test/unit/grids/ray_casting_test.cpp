#include "frontier_pilot/grids/ray_casting.h"
#include "frontier_pilot/core/grid_traversal.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

#include "support/ascii_world.h"

namespace frontier_pilot {
namespace {

using test::AsciiWorld;
using test::drawWorld;

// Where a ray enters the square of a cell, if it does: the slab test, the obvious reference.
double enter(const GridGeometry& geometry, Cell cell, const Vec2& from, const Vec2& unit) {
  double near = 0.0;
  double far = std::numeric_limits<double>::infinity();
  const Vec2 low = geometry.centre(cell) - Vec2::Constant(geometry.resolution / 2.0) - from;
  for (int axis = 0; axis < 2; ++axis) {
    const double a = low[axis] / unit[axis];
    const double b = (low[axis] + geometry.resolution) / unit[axis];
    near = std::max(near, std::min(a, b));
    far = std::min(far, std::max(a, b));
  }
  return near < far ? near : std::numeric_limits<double>::infinity();
}

// The range by asking every solid cell there is.
double bruteForce(const Grid<std::uint8_t>& solid, const Vec2& from, const Vec2& unit, double max_range) {
  double range = max_range;
  for (std::size_t i = 0; i < solid.size(); ++i) {
    if (solid[i] != 0) range = std::min(range, enter(solid.geometry(), solid.geometry().cell(i), from, unit));
  }
  return range;
}

// The range by walking from cell to cell.
double stepByStep(const Grid<std::uint8_t>& solid, const Vec2& from, const Vec2& unit, double max_range) {
  double range = max_range;
  visitCells(solid.geometry(), from, from + max_range * unit, [&](Cell cell) {
    if (solid.get(cell, 0) == 0) return true;
    range = std::min(range, enter(solid.geometry(), cell, from, unit));
    return false;
  });
  return range;
}

Grid<std::uint8_t> randomWorld(std::mt19937& random, double density) {
  GridGeometry geometry;
  geometry.resolution = 0.05;
  geometry.origin = {-1.3, 0.7};
  geometry.width = 20 + static_cast<int>(random() % 60);
  geometry.height = 20 + static_cast<int>(random() % 60);
  Grid<std::uint8_t> solid(geometry);
  const auto blocks = static_cast<int>(density * static_cast<double>(solid.size()));
  for (int i = 0; i < blocks; ++i) solid[random() % solid.size()] = 1;
  return solid;
}

Vec2 randomPoint(std::mt19937& random, const GridGeometry& geometry) {
  std::uniform_real_distribution<double> share(-0.1, 1.1);
  const Vec2 size = Vec2(geometry.width, geometry.height) * geometry.resolution;
  const double x = share(random);
  const double y = share(random);
  return geometry.origin + Vec2(x * size.x(), y * size.y());
}

constexpr double kDensities[] = {0.0, 0.002, 0.02, 0.2, 0.6};
constexpr double kMaxRange = 2.5;

// [SIM-2] exact: no cell missed, and the range is where the ray enters it.
TEST(RayCaster, AgreesWithAskingEverySolidCell_SIM_2) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> angle(-7.0, 7.0);
  for (int world = 0; world < 25; ++world) {
    const Grid<std::uint8_t> solid = randomWorld(random, kDensities[world % 5]);
    const grids::RayCaster caster(solid);
    for (int ray = 0; ray < 80; ++ray) {
      const Vec2 from = randomPoint(random, solid.geometry());
      const Vec2 unit = direction(angle(random));
      ASSERT_NEAR(caster.cast(from, unit, kMaxRange), bruteForce(solid, from, unit, kMaxRange), 1e-6)
          << "world " << world << " from " << from.transpose() << " along " << unit.transpose();
    }
  }
}

TEST(RayCaster, AgreesWithWalkingFromCellToCell_SIM_2) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> angle(-7.0, 7.0);
  for (int world = 0; world < 100; ++world) {
    const Grid<std::uint8_t> solid = randomWorld(random, kDensities[world % 5]);
    const grids::RayCaster caster(solid);
    for (int ray = 0; ray < 500; ++ray) {
      const Vec2 from = randomPoint(random, solid.geometry());
      const Vec2 unit = direction(angle(random));
      ASSERT_NEAR(caster.cast(from, unit, kMaxRange), stepByStep(solid, from, unit, kMaxRange), 1e-6)
          << "world " << world << " from " << from.transpose() << " along " << unit.transpose();
    }
  }
}

TEST(RayCaster, LeapsOverLongEmptyStretchesWithoutMissingAnything) {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> angle(-7.0, 7.0);
  Grid<std::uint8_t> solid(GridGeometry{0.05, {3.0, -2.0}, 1200, 700});
  for (int i = 0; i < 60; ++i) solid[random() % solid.size()] = 1;
  const grids::RayCaster caster(solid);
  for (int ray = 0; ray < 3000; ++ray) {
    const Vec2 from = randomPoint(random, solid.geometry());
    const Vec2 unit = direction(angle(random));
    ASSERT_NEAR(caster.cast(from, unit, 100.0), stepByStep(solid, from, unit, 100.0), 1e-6);
  }
}

TEST(RayCaster, CastsManyRaysAtOnceAsOneByOne) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> angle(-7.0, 7.0);
  std::uniform_real_distribution<double> range(0.0, 3.0);
  for (int world = 0; world < 100; ++world) {
    const Grid<std::uint8_t> solid = randomWorld(random, kDensities[world % 5]);
    const grids::RayCaster caster(solid);
    const Vec2 from = randomPoint(random, solid.geometry());
    std::vector<Vec2> units;
    std::vector<double> ranges;
    std::vector<double> expected;
    for (int ray = 0; ray < 117; ++ray) {
      units.push_back(direction(angle(random)));
      ranges.push_back(range(random));
      expected.push_back(caster.cast(from, units.back(), ranges.back()));
    }
    caster.castAll(from, units, ranges);
    ASSERT_EQ(ranges, expected) << "world " << world;
  }
}

// [SIM-2] no missed corner: the gap between two cells that touch at a corner is no gap.
TEST(RayCaster, DoesNotSlipBetweenDiagonalCells_SIM_2) {
  const AsciiWorld falling = drawWorld(R"(
      ......
      ......
      ..#...
      ...#..
      ......
      ......)");
  const AsciiWorld rising = drawWorld(R"(
      ......
      ......
      ...#..
      ..#...
      ......
      ......)");
  const Vec2 corner(0.15, 0.15);
  for (double away : {0.03, 0.05, 0.1, 0.141}) {
    const Vec2 up = direction(kPi / 4.0);
    const Vec2 down = direction(-kPi / 4.0);
    const grids::RayCaster across_falling(falling.solid());
    EXPECT_NEAR(across_falling.cast(corner - away * up, up, 1.0), away, 1e-9);
    EXPECT_NEAR(across_falling.cast(corner + away * up, Vec2(-up), 1.0), away, 1e-9);
    const grids::RayCaster across_rising(rising.solid());
    EXPECT_NEAR(across_rising.cast(corner - away * down, down, 1.0), away, 1e-9);
    EXPECT_NEAR(across_rising.cast(corner + away * down, Vec2(-down), 1.0), away, 1e-9);
  }
}

TEST(RayCaster, SeesTheSurfaceOfTheCellInEachDirection) {
  const AsciiWorld world = drawWorld(R"(
      #######
      #.....#
      #.....#
      #..r..#
      #.....#
      #.....#
      #######)");
  const grids::RayCaster caster(world.solid());
  for (double angle : {0.0, kPi / 2, kPi, -kPi / 2})
    EXPECT_NEAR(caster.cast(world.point('r'), angle, 8.0), 0.125, 1e-9);
  EXPECT_NEAR(caster.cast(world.point('r'), kPi / 4, 8.0), 0.125 * std::sqrt(2.0), 1e-9);
}

TEST(RayCaster, GivesTheGreatestRangeWhereNothingIsNearer) {
  const AsciiWorld world = drawWorld(R"(
      ..........
      r........#
      ..........)");
  const grids::RayCaster caster(world.solid());
  EXPECT_NEAR(caster.cast(world.point('r'), 0.0, 1.0), 0.425, 1e-9);
  EXPECT_DOUBLE_EQ(caster.cast(world.point('r'), 0.0, 0.4), 0.4);
  EXPECT_DOUBLE_EQ(caster.cast(world.point('r'), kPi, 0.4), 0.4);
  EXPECT_DOUBLE_EQ(caster.cast(world.point('r'), 1.0, 1e6), 1e6);
  EXPECT_DOUBLE_EQ(caster.cast(world.point('r'), 0.0, 0.0), 0.0);
}

TEST(RayCaster, GivesZeroFromInsideASolidCell) {
  const AsciiWorld world = drawWorld("..X..");
  Grid<std::uint8_t> solid(world.map.geometry());
  solid[world.cell('X')] = 1;
  const grids::RayCaster caster(solid);
  for (double angle = -3.1; angle < 3.1; angle += 0.1) EXPECT_EQ(caster.cast(world.point('X'), angle, 8.0), 0.0);
  std::vector<double> ranges = {8.0};
  caster.castAll(world.point('X'), {direction(2.0)}, ranges);
  EXPECT_EQ(ranges.front(), 0.0);
}

TEST(RayCaster, SeesIntoTheGridFromOutside) {
  const AsciiWorld world = drawWorld("..#..");
  const grids::RayCaster caster(world.solid());
  EXPECT_NEAR(caster.cast({-1.0, 0.025}, 0.0, 8.0), 1.1, 1e-9);
  EXPECT_NEAR(caster.cast({0.125, 3.0}, -kPi / 2, 8.0), 2.95, 1e-9);
  EXPECT_EQ(caster.cast({-1.0, 0.025}, kPi, 8.0), 8.0);
  EXPECT_EQ(caster.cast({-1.0, 0.025}, 0.0, 1.05), 1.05);
}

TEST(RayCaster, OfNothingSeesNothing) {
  EXPECT_EQ(grids::RayCaster().cast({0.0, 0.0}, 1.0, 8.0), 8.0);
  EXPECT_EQ(grids::RayCaster(Grid<std::uint8_t>()).cast({0.0, 0.0}, 1.0, 8.0), 8.0);
}

}  // namespace
}  // namespace frontier_pilot
