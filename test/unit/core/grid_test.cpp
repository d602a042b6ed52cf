#include "frontier_pilot/core/grid.h"

#include <gtest/gtest.h>

#include "frontier_pilot/core/grid_traversal.h"
#include "support/ascii_world.h"

namespace frontier_pilot {
namespace {

GridGeometry geometry(int width, int height) {
  GridGeometry out;
  out.resolution = 0.1;
  out.origin = {-1.05, 2.0};
  out.width = width;
  out.height = height;
  return out;
}

TEST(GridGeometry, EveryCellHoldsItsOwnCentreAndIndexRoundTrips) {
  const GridGeometry g = geometry(17, 9);
  for (std::size_t i = 0; i < g.size(); ++i) {
    EXPECT_EQ(g.cellAt(g.centre(g.cell(i))), g.cell(i));
    EXPECT_EQ(g.index(g.cell(i)), i);
  }
  EXPECT_FALSE(g.contains(g.cellAt({-1.06, 2.05})));
  EXPECT_FALSE(g.contains({17, 0}));
}

TEST(Grid, AWrongNumberOfCellsIsRefused) {
  EXPECT_THROW(Grid<int>(geometry(3, 3), std::vector<int>(8)), std::invalid_argument);
}

TEST(CellRect, UnionHoldsBothAndIntersectionLiesInBoth) {
  CellRect a;
  a.include(CellRect{2, 3, 4, 5});
  EXPECT_EQ(a, (CellRect{2, 3, 4, 5}));
  a.include(CellRect{});
  EXPECT_EQ(a, (CellRect{2, 3, 4, 5}));
  a.include(Cell{0, 10});
  EXPECT_EQ(a, (CellRect{0, 3, 6, 8}));
  EXPECT_EQ(a.intersection({4, 0, 10, 5}), (CellRect{4, 3, 2, 2}));
  EXPECT_TRUE(a.intersection({6, 0, 10, 5}).empty());
}

TEST(VisitCells, WalksConnectedFromTheFirstCellToTheLast) {
  const GridGeometry g = geometry(40, 40);
  for (int i = 0; i < 360; ++i) {
    const Vec2 from = g.centre({20, 20}) + Vec2(0.013, -0.021);
    const Vec2 to = from + 1.7 * direction(i * kPi / 180.0);
    std::vector<Cell> cells;
    EXPECT_TRUE(visitCells(g, from, to, [&](Cell c) {
      cells.push_back(c);
      return true;
    }));
    EXPECT_EQ(cells.front(), g.cellAt(from));
    EXPECT_EQ(cells.back(), g.cellAt(to));
    for (std::size_t k = 1; k < cells.size(); ++k) {
      EXPECT_EQ(std::abs(cells[k].x - cells[k - 1].x) + std::abs(cells[k].y - cells[k - 1].y), 1);
    }
  }
}

TEST(VisitCells, StopsWhenTold) {
  int visited = 0;
  EXPECT_FALSE(visitCells(geometry(9, 9), {-1.0, 2.05}, {-0.3, 2.05}, [&](Cell) { return ++visited < 3; }));
  EXPECT_EQ(visited, 3);
}

TEST(AsciiWorld, TheFirstLineIsTheUpperEdgeAndMarksAreFree) {
  const test::AsciiWorld world = test::drawWorld(R"(
      ##?
      #A.
  )");
  EXPECT_EQ(world.map.width(), 3);
  EXPECT_EQ(world.map.height(), 2);
  EXPECT_EQ(world.cell('A'), (Cell{1, 0}));
  EXPECT_EQ(world.map[(Cell{1, 0})], kFree);
  EXPECT_EQ(world.map[(Cell{2, 1})], kUnknown);
  EXPECT_EQ(test::toAscii(world.map, world.marks), "##?\n#A.\n");
}

}  // namespace
}  // namespace frontier_pilot
