#include "frontier_pilot/occupancy/occupancy_map.h"

#include <gtest/gtest.h>

#include <random>
#include <sstream>

#include "occupancy/log_odds.h"
#include "occupancy/octree_layer.h"

namespace frontier_pilot {
namespace {

Cell cellAt(const occupancy::OccupancyMap& map, double x, double y) { return map.geometry().cellAt({x, y}); }

void hit(occupancy::OccupancyMap& map, Cell cell) {
  map.beginScan();
  map.hit(cell);
}
void miss(occupancy::OccupancyMap& map, Cell cell) {
  map.beginScan();
  map.miss(cell);
}

occupancy::OccupancyMap smallMap() {
  occupancy::OccupancyMap map;
  EXPECT_TRUE(map.reserve({-1.0, -1.0}, {1.0, 1.0}));
  return map;
}

/// Hits and misses at random cells of a map that grows meanwhile.
void scribble(occupancy::OccupancyMap& map, int scans) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> place(-12.0, 12.0);
  for (int i = 0; i < scans; ++i) {
    const Vec2 point(place(random), place(random));
    ASSERT_TRUE(map.reserve(point, point));
    map.beginScan();
    for (int k = 0; k < 20; ++k) {
      const Cell cell = map.geometry().cellAt({point.x(), point.y()});
      const Cell near{cell.x, std::max(0, cell.y - k)};
      (i + k) % 3 == 0 ? map.hit(near) : map.miss(near);
    }
  }
}

std::size_t knownCells(const occupancy::OccupancyMap& map) {
  std::size_t known = 0;
  for (const std::int8_t value : map.grid().cells()) known += isUnknown(value) ? 0U : 1U;
  return known;
}

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
  ASSERT_TRUE(map.reserve({-1.0, -1.0}, {1.0, 1.0}));
  const Cell cell = cellAt(map, 0.2, 0.2);
  hit(map, cell);
  EXPECT_EQ(map.grid()[cell], 70);
  miss(map, cell);
  EXPECT_EQ(map.grid()[cell], 61);
}

// [MAP-2] the octree is the truth
TEST(OccupancyMap, HoldsTheSameInTheOctreeAndInItsDenseCopy_MAP_2) {
  occupancy::OccupancyMap map;
  scribble(map, 400);
  std::size_t seen = 0;
  map.octree().forEach([&](Cell cell, float log_odds) {
    const Vec2 centre = (Vec2(cell.x, cell.y) + Vec2(0.5, 0.5)) * map.geometry().resolution;
    float copy = 0.0F;
    ASSERT_TRUE(map.logOdds(map.geometry().cellAt(centre), copy));
    ASSERT_EQ(copy, log_odds);
    ASSERT_EQ(isOccupied(map.grid()[map.geometry().cellAt(centre)]), log_odds >= 0.0F);
    ++seen;
  });
  EXPECT_EQ(seen, knownCells(map));
  EXPECT_GT(seen, 1000U);
}

TEST(OccupancyMap, GrowsWithoutMovingWhatItKnows) {
  occupancy::OccupancyMap map = smallMap();
  hit(map, cellAt(map, 0.52, 0.52));
  miss(map, cellAt(map, -0.93, 0.12));
  const GridGeometry before = map.geometry();
  ASSERT_TRUE(map.reserve({-31.0, -2.0}, {0.0, 44.0}));
  EXPECT_EQ(map.grid()[cellAt(map, 0.52, 0.52)], kOccupied);
  EXPECT_EQ(map.grid()[cellAt(map, -0.93, 0.12)], kFree);
  EXPECT_EQ(knownCells(map), 2U);
  const Vec2 shift = (before.origin - map.geometry().origin) / before.resolution;
  EXPECT_NEAR(shift.x(), std::round(shift.x()), 1e-6) << "cells keep their place";
  EXPECT_LE(map.geometry().origin.x(), -31.0);
  EXPECT_GE(map.geometry().origin.y() + map.geometry().height * 0.05, 44.0);
}

TEST(OccupancyMap, NeverShrinks) {
  occupancy::OccupancyMap map;
  ASSERT_TRUE(map.reserve({-31.0, -2.0}, {0.0, 44.0}));
  const GridGeometry before = map.geometry();
  ASSERT_TRUE(map.reserve({0.0, 0.0}, {0.1, 0.1}));
  map.clear();
  EXPECT_EQ(map.geometry(), before);
}

TEST(OccupancyMap, RefusesToGrowBeyondItsLargestSizeAndStaysAsItWas) {
  occupancy::OccupancyMap map = smallMap();
  const GridGeometry before = map.geometry();
  EXPECT_FALSE(map.reserve({0.0, 0.0}, {500.0, 0.0}));
  EXPECT_FALSE(map.reserve({-1e300, 0.0}, {0.0, 0.0}));
  EXPECT_FALSE(map.reserve({std::nan(""), 0.0}, {0.0, 0.0}));
  EXPECT_EQ(map.geometry(), before);
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
  ASSERT_TRUE(map.reserve({-31.0, -2.0}, {0.0, 44.0}));
  const occupancy::MapChanges grown = map.takeChanges();
  EXPECT_TRUE(grown.geometry_changed);
  EXPECT_EQ(grown.cells, map.geometry().rect());
  map.clear();
  EXPECT_EQ(map.takeChanges().cells, map.geometry().rect());
  EXPECT_EQ(knownCells(map), 0U);
  EXPECT_EQ(map.octree().leafCount(), 0U);
}

// [MAP-2]
TEST(OccupancyMap, IsTheSameAfterAWriteAndARead_MAP_2) {
  occupancy::OccupancyMap map;
  scribble(map, 300);
  std::stringstream file;
  ASSERT_TRUE(map.write(file));
  occupancy::OccupancyMap copy;
  ASSERT_TRUE(copy.reserve(map.geometry().origin + Vec2(1.0, 1.0), Vec2(9.0, 9.0)));
  std::string why;
  ASSERT_TRUE(copy.read(file.str(), why)) << why;
  EXPECT_EQ(copy.geometry(), map.geometry());
  EXPECT_TRUE(copy.grid().cells() == map.grid().cells());
}

TEST(OccupancyMap, LosesNothingByWriting) {
  occupancy::OccupancyMap map;
  scribble(map, 50);
  occupancy::OccupancyMap twin;
  scribble(twin, 50);
  std::stringstream file;
  ASSERT_TRUE(map.write(file));
  for (std::size_t i = 0; i < map.grid().size(); ++i) {
    const Cell cell = map.geometry().cell(i);
    float a = 0.0F;
    float b = 0.0F;
    ASSERT_EQ(map.logOdds(cell, a), twin.logOdds(cell, b));
    ASSERT_EQ(a, b);
  }
}

TEST(OccupancyMap, KeepsItsContentWhenReadingFails) {
  occupancy::OccupancyMap map;
  scribble(map, 20);
  const auto before = map.grid().cells();
  std::string why;
  EXPECT_FALSE(map.read("this is no octree\n", why));
  EXPECT_NE(why.find("no octree"), std::string::npos) << why;
  occupancy::OccupancyMapParameters coarse;
  coarse.resolution = 0.1;
  occupancy::OccupancyMap other(coarse);
  ASSERT_TRUE(other.reserve({0.0, 0.0}, {1.0, 1.0}));
  hit(other, {3, 3});
  std::stringstream file;
  ASSERT_TRUE(other.write(file));
  EXPECT_FALSE(map.read(file.str(), why)) << "another resolution";
  EXPECT_TRUE(map.grid().cells() == before);
}

TEST(OccupancyMap, GoesOnMappingAfterARead) {
  occupancy::OccupancyMap map = smallMap();
  const Cell cell = cellAt(map, 0.2, 0.2);
  hit(map, cell);
  std::stringstream file;
  ASSERT_TRUE(map.write(file));
  std::string why;
  ASSERT_TRUE(map.read(file.str(), why)) << why;
  for (int i = 0; i < 9; ++i) miss(map, cellAt(map, 0.2, 0.2));
  EXPECT_EQ(map.grid()[cellAt(map, 0.2, 0.2)], kFree);
  std::size_t free = 0;
  map.octree().forEach([&](Cell, float log_odds) { free += log_odds < 0.0F ? 1U : 0U; });
  EXPECT_EQ(free, 1U);
}

}  // namespace
}  // namespace frontier_pilot
