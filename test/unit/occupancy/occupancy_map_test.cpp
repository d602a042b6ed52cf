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

// [MAP-2]
TEST(OccupancyMap, HoldsTheSameAsTheOctreeThatItGives_MAP_2) {
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
  EXPECT_FALSE(map.reserve({0.0, 0.0}, {1500.0, 0.0}));
  EXPECT_FALSE(map.reserve({-1e300, 0.0}, {0.0, 0.0}));
  EXPECT_FALSE(map.reserve({std::nan(""), 0.0}, {0.0, 0.0}));
  EXPECT_EQ(map.geometry(), before);
}

// Maps of hundreds of metres
TEST(OccupancyMap, TakesMemoryForWhatIsMappedAndNotForTheBoxAroundIt) {
  occupancy::OccupancyMap map = smallMap();
  miss(map, cellAt(map, 0.2, 0.2));
  const std::size_t before = map.memory();
  ASSERT_TRUE(map.reserve({-300.0, -300.0}, {300.0, 300.0}));
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
  ASSERT_TRUE(map.reserve({0.0, 0.0}, {100.0, 100.0}));
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

TEST(OccupancyMap, RefusesAFileThatNeedsMoreMemoryThanItMayTake) {
  occupancy::OccupancyMap large;
  ASSERT_TRUE(large.reserve({0.0, 0.0}, {100.0, 100.0}));
  for (int y = 0; y < 1000; y += 64) {
    for (int x = 0; x < 1000; x += 64) miss(large, {x, y});
  }
  std::stringstream file;
  ASSERT_TRUE(large.write(file));
  occupancy::OccupancyMapParameters parameters;
  parameters.max_memory = 1.0;
  occupancy::OccupancyMap map(parameters);
  std::string why;
  EXPECT_FALSE(map.read(file.str(), why));
  EXPECT_NE(why.find("max_memory"), std::string::npos) << why;
  EXPECT_TRUE(map.empty());
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

// Numbers of scans have 16 bits.
TEST(OccupancyMap, TakesHitsBeforeMissesAlsoAfterManyScans) {
  occupancy::OccupancyMap map = smallMap();
  const Cell cell = cellAt(map, 0.2, 0.2);
  for (int i = 0; i < 70000; ++i) {
    map.beginScan();
    map.hit(cell);
    map.miss(cell);
  }
  float log_odds = 0.0F;
  ASSERT_TRUE(map.logOdds(cell, log_odds));
  EXPECT_FLOAT_EQ(log_odds, occupancy::logOdds(0.97));
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

// [MAP-2]
TEST(OccupancyMap, WritesTheBytesThatOctoMapWritesAndOctoMapReadsThem_MAP_2) {
  occupancy::OccupancyMap map;
  scribble(map, 300);
  std::stringstream ours;
  std::stringstream octomaps;
  ASSERT_TRUE(map.write(ours));
  ASSERT_TRUE(map.octree().write(octomaps));
  EXPECT_TRUE(ours.str() == octomaps.str());
  occupancy::OctreeLayer read = occupancy::OccupancyMap().octree();
  ASSERT_TRUE(read.read(ours.str()));
  std::size_t leaves = 0;
  read.forEach([&](Cell cell, float log_odds) {
    const Vec2 centre = (Vec2(cell.x, cell.y) + Vec2(0.5, 0.5)) * map.geometry().resolution;
    ASSERT_EQ(map.isOccupied(map.geometry().cellAt(centre)), log_odds >= 0.0F);
    ++leaves;
  });
  EXPECT_EQ(leaves, knownCells(map));
}

// [MAP-5] An octree that was pruned holds cubes of cells as single leaves.
TEST(OccupancyMap, ReadsLeavesThatStandForCubesOfCells) {
  occupancy::OccupancyMap map;
  // Fourteen inner nodes, one below the other, and then a free cube of four cells along a side.
  std::string tree;
  const occupancy::OccupancyMapParameters parameters;
  const int z = static_cast<int>(parameters.scanner_height / parameters.resolution);
  for (int level = 16; level > 2; --level) {
    // The cube lies at x = y = 0: the upper half at the root, the lower half from then on.
    const int up = level == 16 ? 1 : 0;
    const int child = up | up << 1 | (level == 16 ? 1 : (z >> (level - 1)) & 1) << 2;
    const unsigned kind = level == 3 ? 1U : 3U;
    const unsigned bits = kind << (2 * child);
    tree += static_cast<char>(bits & 0xFFU);
    tree += static_cast<char>(bits >> 8U);
  }
  const std::string file = "# Octomap OcTree binary file\nid OcTree\nsize 15\nres 0.05\ndata\n" + tree;
  std::string why;
  ASSERT_TRUE(map.read(file, why)) << why;
  EXPECT_EQ(knownCells(map), 16U);
  EXPECT_EQ(map.grid()[cellAt(map, 0.02, 0.18)], kFree);
  EXPECT_EQ(map.grid()[cellAt(map, 0.22, 0.18)], kUnknown);
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
