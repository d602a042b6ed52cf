#include <gtest/gtest.h>

#include <sstream>
#include <string>

#include "occupancy/octree_layer.h"
#include "scribbled_map.h"

namespace frontier_pilot {
namespace {

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

TEST(OccupancyMap, RefusesAFileThatNeedsMoreMemoryThanItMayTake) {
  occupancy::OccupancyMap large;
  ASSERT_EQ(large.reserve({0.0, 0.0}, {100.0, 100.0}), occupancy::MapRoom::kEnough);
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

// [MAP-2]
TEST(OccupancyMap, IsTheSameAfterAWriteAndARead_MAP_2) {
  occupancy::OccupancyMap map;
  scribble(map, 300);
  std::stringstream file;
  ASSERT_TRUE(map.write(file));
  occupancy::OccupancyMap copy;
  ASSERT_EQ(copy.reserve(map.geometry().origin + Vec2(1.0, 1.0), Vec2(9.0, 9.0)), occupancy::MapRoom::kEnough);
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
  ASSERT_EQ(other.reserve({0.0, 0.0}, {1.0, 1.0}), occupancy::MapRoom::kEnough);
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
