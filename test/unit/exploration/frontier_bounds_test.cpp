#include <gtest/gtest.h>

#include <algorithm>

#include "exploration/frontier_evaluator.h"
#include "exploration/frontier_search.h"
#include "explorer_fixture.h"
#include "frontier_pilot/core/bounds.h"

namespace frontier_pilot {
namespace {

/// A map full of `ground`, but for each cell whose row and column are multiples of `spacing`.
OccupancyGrid lattice(int side, int spacing, std::int8_t ground, std::int8_t points, double resolution = 0.05) {
  GridGeometry geometry;
  geometry.width = geometry.height = side;
  geometry.resolution = resolution;
  OccupancyGrid map(geometry, ground);
  for (int y = 0; y < side; y += spacing) {
    for (int x = 0; x < side; x += spacing) map[Cell{x, y}] = points;
  }
  return map;
}

/// Eight of nine cells are frontier cells, and all hang together.
OccupancyGrid allFrontier() { return lattice(1600, 3, kFree, kUnknown); }
/// Every ninth cell is a frontier of its own.
OccupancyGrid aFrontierInEachNinthCell() { return lattice(1000, 3, kUnknown, kFree); }

TEST(FrontierBounds, ANoisyMapGivesNoClustersWhenItHasTooManyFrontierCells_FLT_1) {
  OccupancyGrid map = allFrontier();
  exploration::FrontierSearch search;
  search.update(map, map.geometry().rect());
  ASSERT_GT(search.cellCount(), bounds::kMostFrontierCells);
  const exploration::FrontierClusters all = search.clusters();
  EXPECT_TRUE(all.too_many);
  EXPECT_TRUE(all.clusters.empty());
  EXPECT_TRUE(all.runs.empty());
}

TEST(FrontierBounds, ANoisyMapGivesNoClustersWhenItHasTooMany_FLT_1) {
  const OccupancyGrid map = aFrontierInEachNinthCell();
  exploration::FrontierSearch search;
  search.update(map, map.geometry().rect());
  ASSERT_LE(search.cellCount(), bounds::kMostFrontierCells);
  ASSERT_GT(search.cellCount(), bounds::kMostFrontiers) << "each is one";
  EXPECT_TRUE(search.clusters().too_many);
  EXPECT_TRUE(search.clusters().clusters.empty());
}

TEST(FrontierBounds, WhenTheNoiseGoesBlockByBlockTheFrontierIsThatOfTheWholeMapAgain_FLT_1) {
  OccupancyGrid map = allFrontier();
  exploration::FrontierSearch search;
  search.update(map, map.geometry().rect());
  for (const CellRect& block : {CellRect{0, 0, 1600, 200}, CellRect{0, 200, 700, 1400}}) {
    for (int y = block.y; y < block.y + block.height; ++y) std::fill_n(map.row(y) + block.x, block.width, kFree);
    search.update(map, block);
  }
  exploration::FrontierSearch fresh;
  fresh.update(map, map.geometry().rect());
  EXPECT_EQ(search.cellCount(), fresh.cellCount());
  ASSERT_FALSE(search.clusters().too_many);
  EXPECT_EQ(search.clusters().runs.size(), fresh.clusters().runs.size());
}

TEST(FrontierBounds, OnlySoManyFrontiersAreJudgedTheLargeAndNearOnesFirst_FLT_1) {
  OccupancyGrid floor = lattice(600, 6, kFree, kUnknown, 0.2);
  for (int y = 400; y < 404; ++y) std::fill_n(floor.row(y) + 300, 4, kUnknown);
  exploration::FrontierEvaluator evaluator{exploration::FrontierParameters{}, Outline::disc(0.105)};
  evaluator.setMap(floor, floor.geometry().rect());
  const Vec2 robot = floor.geometry().centre({63, 63});
  evaluator.evaluate({robot, robot, nullptr, 0.0});
  const auto& all = evaluator.frontiers();
  const auto count = [&](exploration::Rejection rejection) {
    return static_cast<std::size_t>(std::count_if(
        all.begin(), all.end(), [&](const exploration::Frontier& f) { return f.rejection == rejection; }));
  };
  EXPECT_EQ(all.size() - count(exploration::Rejection::kTooSmall) - count(exploration::Rejection::kLeftOut),
            bounds::kMostJudgedFrontiers);
  EXPECT_EQ(evaluator.leftOut(), count(exploration::Rejection::kLeftOut));
  for (const exploration::Frontier& f : all) {
    const bool near = (f.centroid - robot).norm() < 10.0;
    const bool large = f.cell_count > 12;
    EXPECT_FALSE((near || large) && f.rejection == exploration::Rejection::kLeftOut) << f.centroid.transpose();
  }
}

using TooManyFrontiers = test::ExplorerTest;

TEST_F(TooManyFrontiers, AreSaidToBeSoAndAnOrdinaryMapIsExploredAgain_FLT_1_EXP_7) {
  OccupancyGrid noise = aFrontierInEachNinthCell();
  for (int y = 490; y < 510; ++y) std::fill_n(noise.row(y) + 490, 20, kFree);
  explorer.setMap(noise, noise.geometry().rect());
  pose = Pose2(noise.geometry().centre({501, 501}), 0.0);
  const exploration::ExplorerOutput output = tickFor(5.0);
  EXPECT_EQ(output.status.state, exploration::ExplorerState::kDone);
  EXPECT_EQ(output.status.reason, exploration::ExplorerReason::kTooManyFrontiers) << output.status.reason_text;
  EXPECT_EQ(output.status.frontiers_found, 0U);
  EXPECT_EQ(notesWith("too many frontiers"), 1U);
  pose = Pose2(1.0, 0.3, 0.0);
  show(kRoom);
  tickFor(5.0);
  EXPECT_TRUE(wentThrough(exploration::ExplorerState::kNavigating, exploration::ExplorerReason::kGoalSent));
}

}  // namespace
}  // namespace frontier_pilot
