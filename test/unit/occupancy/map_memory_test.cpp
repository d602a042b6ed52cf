#include <gtest/gtest.h>

#include "occupancy/log_odds.h"
#include "scribbled_map.h"

namespace frontier_pilot {
namespace {

// Maps of hundreds of metres
TEST(OccupancyMap, TakesMemoryForWhatIsMappedAndNotForTheBoxAroundIt) {
  occupancy::OccupancyMap map = smallMap();
  miss(map, cellAt(map, 0.2, 0.2));
  const std::size_t before = map.memory();
  ASSERT_EQ(map.reserve({-300.0, -300.0}, {300.0, 300.0}), occupancy::MapRoom::kEnough);
  hit(map, cellAt(map, -299.0, 299.0));
  EXPECT_GE(map.geometry().size(), 144'000'000U);
  EXPECT_LT(map.memory(), before + 1'000'000U);
  EXPECT_EQ(map.projection({0, 0, 1, 1})[0], kUnknown);
  EXPECT_TRUE(map.isOccupied(cellAt(map, -299.0, 299.0)));
  float free = 0.0F;
  EXPECT_TRUE(map.logOdds(cellAt(map, 0.2, 0.2), free));
}

TEST(OccupancyMap, AddsNothingNewBeyondItsMemoryAndGoesOnUpdatingWhatIsKnown) {
  occupancy::OccupancyMapParameters parameters;
  parameters.max_memory = 1.0;
  occupancy::OccupancyMap map(parameters);
  ASSERT_EQ(map.reserve({0.0, 0.0}, {100.0, 100.0}), occupancy::MapRoom::kEnough);
  for (int i = 0; i < 60; ++i) miss(map, {i, i});
  EXPECT_FALSE(map.isFull());
  for (int y = 0; y < 1000; y += 64) {
    for (int x = 0; x < 1000; x += 64) miss(map, {x, y});
  }
  EXPECT_TRUE(map.isFull());
  const Cell first{0, 0};
  for (int i = 0; i < 9; ++i) hit(map, first);
  EXPECT_TRUE(map.isOccupied(first));
  EXPECT_LT(knownCells(map), 200U);
  map.clear();
  EXPECT_FALSE(map.isFull());
  miss(map, {1500, 1500});
  EXPECT_EQ(map.grid()[Cell({1500, 1500})], kFree);
}

TEST(OccupancyMap, KeepsItsProjectionUpToDateAfterTheFirstCall_MAP_2) {
  occupancy::OccupancyMap map;
  scribble(map, 100);
  EXPECT_TRUE(map.grid().cells() == map.projection().cells());
  scribble(map, 200);
  EXPECT_TRUE(map.grid().cells() == map.projection().cells());
  occupancy::OccupancyMap other;
  scribble(other, 50);
  ASSERT_TRUE(map.exchange(other));
  EXPECT_TRUE(map.grid().cells() == map.projection().cells());
  EXPECT_TRUE(other.grid().cells() == other.projection().cells());
  const CellRect block{3, 5, 70, 90};
  const OccupancyGrid part = map.projection(block);
  for (int y = 0; y < block.height; ++y) {
    for (int x = 0; x < block.width; ++x) ASSERT_EQ((part[Cell{x, y}]), (map.grid()[Cell{x + 3, y + 5}]));
  }
  map.clear();
  EXPECT_TRUE(map.grid().cells() == map.projection().cells());
}

// Otherwise two small maps far apart, loaded one after the other, would leave a box that nobody else can work with.
TEST(OccupancyMap, MakesItsBoxAnewOnceNothingInItIsKnown) {
  occupancy::OccupancyMap map;
  ASSERT_EQ(map.reserve({299.0, 299.0}, {301.0, 301.0}), occupancy::MapRoom::kEnough);
  hit(map, cellAt(map, 300.0, 300.0));
  occupancy::OccupancyMap other;
  ASSERT_EQ(other.reserve({-301.0, -301.0}, {-299.0, -299.0}), occupancy::MapRoom::kEnough);
  hit(other, cellAt(other, -300.0, -300.0));
  const GridGeometry of_other = other.geometry();
  map.takeChanges();
  map.clear();
  ASSERT_TRUE(map.exchange(other));
  EXPECT_EQ(map.geometry(), of_other);
  const occupancy::MapChanges changes = map.takeChanges();
  EXPECT_TRUE(changes.geometry_changed);
  EXPECT_EQ(changes.cells, map.geometry().rect());
  map.clear();
  ASSERT_EQ(map.reserve({-1.0, -1.0}, {1.0, 1.0}), occupancy::MapRoom::kEnough);
  EXPECT_LT(map.geometry().size(), 1'000'000U);
  EXPECT_EQ(map.takeChanges().cells, map.geometry().rect());
  hit(map, cellAt(map, 0.5, 0.5));
  EXPECT_TRUE(map.grid().cells() == map.projection().cells());
  ASSERT_EQ(map.reserve({10.0, 10.0}, {11.0, 11.0}), occupancy::MapRoom::kEnough);
  EXPECT_TRUE(map.isOccupied(cellAt(map, 0.5, 0.5))) << "what is known stays inside";
}

// Numbers of scans have 16 bits: they begin anew, at 1, since 0 stands in cells that no scan has updated.
TEST(OccupancyMap, CountsAHitWhateverTheNumberOfTheScanThatUpdatedTheCellBefore) {
  for (const int later : {65535, 65536}) {
    occupancy::OccupancyMap map = smallMap();
    const Cell cell = cellAt(map, 0.2, 0.2);
    const Cell fresh = cellAt(map, 0.4, 0.2);
    hit(map, cell);
    for (int i = 1; i < later; ++i) map.beginScan();
    map.beginScan();
    for (const Cell each : {cell, fresh}) {
      map.hit(each);
      map.miss(each);  // of a beam that passed it: the hit takes precedence
    }
    const float one_hit = occupancy::logOdds(map.parameters().model.hit);
    float log_odds = 0.0F;
    ASSERT_TRUE(map.logOdds(cell, log_odds)) << later;
    EXPECT_FLOAT_EQ(log_odds, 2.0F * one_hit) << later;
    ASSERT_TRUE(map.logOdds(fresh, log_odds)) << later;
    EXPECT_FLOAT_EQ(log_odds, one_hit) << later;
  }
}

}  // namespace
}  // namespace frontier_pilot
