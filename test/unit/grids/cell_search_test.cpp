#include "frontier_pilot/grids/cell_search.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <utility>
#include <vector>

namespace frontier_pilot {
namespace {

using Entries = std::vector<std::pair<std::uint32_t, std::uint32_t>>;  ///< value and key

TEST(NeighbourSteps, GoOnceRoundCounterClockwiseWithTheDiagonalsAtOddNumbers) {
  for (std::size_t i = 0; i < 8; ++i) {
    const Cell step = grids::kNeighbourSteps[i];
    const Cell next = grids::kNeighbourSteps[(i + 1) % 8];
    const Cell opposite = grids::kNeighbourSteps[(i + 4) % 8];
    EXPECT_EQ(step.x != 0 && step.y != 0, i % 2 == 1) << i;
    EXPECT_EQ(step.x * next.y - step.y * next.x, 1) << "an eighth of a turn to the left of " << i;
    EXPECT_EQ(opposite, (Cell{-step.x, -step.y}));
  }
}

TEST(NeighbourSteps, OffsetsLeadFromACellToItsNeighbours) {
  GridGeometry geometry;
  geometry.width = 7;
  geometry.height = 5;
  const Cell cell{3, 2};
  for (std::size_t i = 0; i < 8; ++i) {
    const Cell step = grids::kNeighbourSteps[i];
    EXPECT_EQ(geometry.index(cell) + grids::neighbourOffsets(geometry.width)[i],
              geometry.index({cell.x + step.x, cell.y + step.y}));
  }
}

TEST(BucketQueue, GivesTheLeastKeyFirstAndOfEqualOnesTheLastPushed) {
  grids::BucketQueue<8> queue;
  queue.reset(10);
  queue.push(1, 12);
  queue.push(2, 10);
  queue.push(3, 12);
  queue.push(4, 17);
  std::vector<std::uint32_t> order;
  while (!queue.empty()) {
    order.push_back(queue.pop());
    if (order.size() == 1) queue.push(5, 11);
  }
  EXPECT_EQ(order, (std::vector<std::uint32_t>{2, 5, 3, 1, 4}));
}

TEST(BucketQueue, GivesAllOfTheLeastKeyInTheirOrderWhileGreaterOnesArePushed) {
  grids::BucketQueue<8> queue;
  queue.reset(0);
  queue.push(1, 6);
  queue.push(2, 6);
  Entries taken;
  while (!queue.empty()) {
    queue.popLeast([&](std::uint32_t value, std::uint32_t key) {
      taken.emplace_back(value, key);
      if (value < 3) queue.push(value + 10, key + 7);
    });
  }
  EXPECT_EQ(taken, (Entries{{1, 6}, {2, 6}, {11, 13}, {12, 13}}));
}

TEST(BucketQueue, AResetForgetsWhatIsInIt) {
  grids::BucketQueue<8> queue;
  queue.reset(0);
  queue.push(1, 3);
  queue.reset(100);
  EXPECT_TRUE(queue.empty());
  queue.push(2, 101);
  EXPECT_EQ(queue.pop(), 2U);
}

/// A row of cells in which the robot's centre may be from column 3 on and from column -5 down.
class ExitSearchTest : public ::testing::Test {
 protected:
  std::vector<std::pair<Cell, double>> exits(int reach, bool beyond) {
    grids::ExitSearch search({0, 0}, reach);
    std::vector<std::pair<Cell, double>> found;
    search.run(
        beyond, [](Cell cell) { return cell.x >= 3 || cell.x <= -5; },
        [](Cell, Cell next) { return next.y == 0 ? 2.0 : -1.0; },
        [&](Cell cell, double cost) {
          found.emplace_back(cell, cost);
          way = search.wayTo(cell);
        });
    return found;
  }
  std::vector<Cell> way;
};

TEST_F(ExitSearchTest, FindsTheFirstCellOnEachWayTheCheapestFirst) {
  EXPECT_EQ(exits(6, false), (std::vector<std::pair<Cell, double>>{{{3, 0}, 6.0}, {{-5, 0}, 10.0}}));
  EXPECT_EQ(way, (std::vector<Cell>{{0, 0}, {-1, 0}, {-2, 0}, {-3, 0}, {-4, 0}, {-5, 0}}));
}

TEST_F(ExitSearchTest, GoesOnThroughExitsWhenItIsTo) {
  EXPECT_EQ(exits(4, true), (std::vector<std::pair<Cell, double>>{{{3, 0}, 6.0}, {{4, 0}, 8.0}}));
}

TEST_F(ExitSearchTest, LooksNoFartherThanItsReach) { EXPECT_TRUE(exits(2, true).empty()); }

}  // namespace
}  // namespace frontier_pilot
