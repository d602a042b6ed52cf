#include "frontier_pilot/occupancy/occupancy_map.h"

#include <gtest/gtest.h>

#include "occupancy/log_odds.h"
#include "occupancy/octree_layer.h"
#include "scribbled_map.h"

namespace frontier_pilot {
namespace {

// [MAP-2]
TEST(OccupancyMap, StartsUnknownAndTakesOneHitOrMissForAnAnswer_MAP_2) {
  occupancy::OccupancyMap map = smallMap();
  const Cell a = cellAt(map, 0.2, 0.2);
  const Cell b = cellAt(map, -0.2, 0.2);
  EXPECT_EQ(map.grid()[a], kUnknown);
  hit(map, a);
  miss(map, b);
  EXPECT_EQ(map.grid()[a], kOccupied);
  EXPECT_EQ(map.grid()[b], kFree);
}

TEST(OccupancyMap, AHitWinsOverMissesOfTheSameScan) {
  occupancy::OccupancyMap map = smallMap();
  const Cell cell = cellAt(map, 0.2, 0.2);
  for (int i = 0; i < 20; ++i) {
    map.beginScan();
    map.hit(cell);
    for (int k = 0; k < 10; ++k) map.miss(cell);
  }
  float log_odds = 0.0F;
  ASSERT_TRUE(map.logOdds(cell, log_odds));
  EXPECT_FLOAT_EQ(log_odds, occupancy::logOdds(0.97)) << "also when the cell is as sure as it may be";
}

// [MAP-2] log-odds, clamping
TEST(OccupancyMap, ChangesItsMindInASmallNumberOfScansHoweverSureItWas_MAP_2) {
  occupancy::OccupancyMap map = smallMap();
  const Cell cell = cellAt(map, 0.2, 0.2);
  for (int i = 0; i < 1000; ++i) hit(map, cell);
  int misses = 0;
  while (map.isOccupied(cell) && misses < 100) {
    miss(map, cell);
    ++misses;
  }
  EXPECT_EQ(misses, 9) << "from 0.97 by 0.4: ceil(3.476 / 0.405)";
  for (int i = 0; i < 1000; ++i) miss(map, cell);
  int hits = 0;
  while (!map.isOccupied(cell) && hits < 100) {
    hit(map, cell);
    ++hits;
  }
  EXPECT_EQ(hits, 3) << "from 0.12 by 0.7: ceil(1.992 / 0.847)";
}

TEST(OccupancyMap, ProjectsProbabilitiesOnRequest) {
  occupancy::OccupancyMapParameters parameters;
  parameters.probabilities = true;
  occupancy::OccupancyMap map(parameters);
  ASSERT_EQ(map.reserve({-1.0, -1.0}, {1.0, 1.0}), occupancy::MapRoom::kEnough);
  const Cell cell = cellAt(map, 0.2, 0.2);
  hit(map, cell);
  EXPECT_EQ(map.grid()[cell], 70);
  miss(map, cell);
  EXPECT_EQ(map.grid()[cell], 61);
}

TEST(OccupancyMap, GrowsWithoutMovingWhatItKnows) {
  occupancy::OccupancyMap map = smallMap();
  hit(map, cellAt(map, 0.52, 0.52));
  miss(map, cellAt(map, -0.93, 0.12));
  const GridGeometry before = map.geometry();
  ASSERT_EQ(map.reserve({-31.0, -2.0}, {0.0, 44.0}), occupancy::MapRoom::kEnough);
  EXPECT_EQ(map.grid()[cellAt(map, 0.52, 0.52)], kOccupied);
  EXPECT_EQ(map.grid()[cellAt(map, -0.93, 0.12)], kFree);
  EXPECT_EQ(knownCells(map), 2U);
  const Vec2 shift = (before.origin - map.geometry().origin) / before.resolution;
  EXPECT_NEAR(shift.x(), std::round(shift.x()), 1e-6) << "cells keep their place";
  EXPECT_LE(map.geometry().origin.x(), -31.0);
  EXPECT_GE(map.geometry().origin.y() + map.geometry().height * 0.05, 44.0);
}

TEST(OccupancyMap, NeverShrinksWhileACellOfItIsKnown) {
  occupancy::OccupancyMap map;
  ASSERT_EQ(map.reserve({-31.0, -2.0}, {0.0, 44.0}), occupancy::MapRoom::kEnough);
  const GridGeometry before = map.geometry();
  miss(map, cellAt(map, -30.0, 40.0));
  ASSERT_EQ(map.reserve({0.0, 0.0}, {0.1, 0.1}), occupancy::MapRoom::kEnough);
  map.clear();
  EXPECT_EQ(map.geometry(), before);
}

TEST(OccupancyMap, RefusesToGrowBeyondItsLargestSizeAndStaysAsItWas) {
  occupancy::OccupancyMap map = smallMap();
  const GridGeometry before = map.geometry();
  EXPECT_EQ(map.reserve({0.0, 0.0}, {1500.0, 0.0}), occupancy::MapRoom::kTooLarge);
  EXPECT_EQ(map.reserve({-1e300, 0.0}, {0.0, 0.0}), occupancy::MapRoom::kTooFar);
  EXPECT_EQ(map.reserve({std::nan(""), 0.0}, {0.0, 0.0}), occupancy::MapRoom::kTooFar);
  EXPECT_EQ(map.geometry(), before);
}

// A map of a few metres may lie where no map reaches, as one with the coordinates of a whole country.
TEST(OccupancyMap, TellsABoxThatLiesTooFarAwayFromOneThatIsTooLarge) {
  occupancy::OccupancyMap map;
  EXPECT_EQ(map.reserve({0.0, 1600.0}, {1.0, 1601.0}), occupancy::MapRoom::kEnough);
  EXPECT_EQ(map.reserve({0.0, 1638.0}, {1.0, 1639.0}), occupancy::MapRoom::kTooFar);
  EXPECT_EQ(map.reserve({-4e8, 0.0}, {-4e8, 1.0}), occupancy::MapRoom::kTooFar);
  EXPECT_EQ(map.reserve({0.0, 0.0}, {1500.0, 0.0}), occupancy::MapRoom::kTooLarge);
  EXPECT_EQ(map.describe(occupancy::MapRoom::kTooFar), "lies farther than 1638.4 m from the frame's origin");
  EXPECT_EQ(map.describe(occupancy::MapRoom::kEnough), "");
}

// [MAP-2] The map grows by 10 m: a box around the robot that is rounded to that is 20 m wide.
TEST(OccupancyMap, TakesWhatFitsIntoItsLargestSizeThoughNotRounded_MAP_2) {
  occupancy::OccupancyMapParameters parameters;
  parameters.max_side = 15.0;
  occupancy::OccupancyMap map(parameters);
  ASSERT_EQ(map.reserve({-5.0, -5.0}, {5.0, 5.0}), occupancy::MapRoom::kEnough);
  hit(map, cellAt(map, 1.0, 1.0));
  EXPECT_EQ(map.reserve({-5.0, -7.0}, {5.0, 7.0}), occupancy::MapRoom::kEnough);
  EXPECT_TRUE(map.isOccupied(cellAt(map, 1.0, 1.0)));
  occupancy::OccupancyMap other(parameters);
  ASSERT_EQ(other.reserve({-1.0, -7.0}, {1.0, 7.0}), occupancy::MapRoom::kEnough);
  EXPECT_TRUE(map.hasRoomFor(other));
  EXPECT_EQ(map.reserve({-5.0, -8.0}, {5.0, 8.0}), occupancy::MapRoom::kTooLarge);
}

// [MAP-2] change detection
TEST(OccupancyMap, TellsWhichBlockOfValuesChanged_MAP_2) {
  occupancy::OccupancyMap map = smallMap();
  EXPECT_TRUE(map.takeChanges().geometry_changed);
  EXPECT_TRUE(map.takeChanges().empty());
  const Cell a = cellAt(map, 0.2, 0.2);
  miss(map, a);
  miss(map, {a.x + 3, a.y + 1});
  const occupancy::MapChanges changes = map.takeChanges();
  EXPECT_FALSE(changes.geometry_changed);
  EXPECT_EQ(changes.cells, (CellRect{a.x, a.y, 4, 2}));
  miss(map, a);
  EXPECT_TRUE(map.takeChanges().empty()) << "surer, but still free";
}

TEST(OccupancyMap, ReportsAllOfItAfterItHasGrownOrWasCleared) {
  occupancy::OccupancyMap map = smallMap();
  map.takeChanges();
  ASSERT_EQ(map.reserve({-31.0, -2.0}, {0.0, 44.0}), occupancy::MapRoom::kEnough);
  const occupancy::MapChanges grown = map.takeChanges();
  EXPECT_TRUE(grown.geometry_changed);
  EXPECT_EQ(grown.cells, map.geometry().rect());
  map.clear();
  EXPECT_EQ(map.takeChanges().cells, map.geometry().rect());
  EXPECT_EQ(knownCells(map), 0U);
  EXPECT_EQ(map.octree().leafCount(), 0U);
}

}  // namespace
}  // namespace frontier_pilot
