#include "ros/common/maps/block_changes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace frontier_pilot {
namespace {

GridGeometry geometryOf(int width, int height) { return {0.05, Vec2(-1.0, 2.0), width, height}; }

OccupancyGrid part(const OccupancyGrid& map, const CellRect& rect) {
  OccupancyGrid cells(geometryOf(rect.width, rect.height));
  for (int y = 0; y < rect.height; ++y) std::copy_n(map.row(rect.y + y) + rect.x, rect.width, cells.row(y));
  return cells;
}

std::vector<CellRect> take(BlockChanges& changes, const OccupancyGrid& map, const CellRect& cells) {
  const CellRect place = changes.blocksAround(cells);
  return place.empty() ? std::vector<CellRect>() : changes.take(part(map, place), place);
}

/// A map of which everything was sent.
BlockChanges sent(const OccupancyGrid& map) {
  BlockChanges changes;
  changes.reset(map.geometry());
  take(changes, map, map.geometry().rect());
  return changes;
}

TEST(BlockChanges, AllBlocksAreNewAtFirstAndNoneAfterThat) {  // [MUL-1]
  const OccupancyGrid map(geometryOf(40, 20), kUnknown);
  BlockChanges changes;
  changes.reset(map.geometry());
  const std::vector<CellRect> all = {{0, 0, 40, 16}, {0, 16, 40, 4}};
  EXPECT_EQ(take(changes, map, map.geometry().rect()), all);
  EXPECT_TRUE(take(changes, map, map.geometry().rect()).empty());
  changes.reset(map.geometry());
  EXPECT_EQ(take(changes, map, map.geometry().rect()), all) << "begun anew";
}

TEST(BlockChanges, OnlyBlocksWithAnotherValueAreFoundHoweverLargeTheBoxAroundThem) {  // [MUL-1]
  OccupancyGrid map(geometryOf(100, 100), kFree);
  BlockChanges changes = sent(map);
  map[(Cell{3, 5})] = kOccupied;
  map[(Cell{99, 99})] = kUnknown;
  EXPECT_EQ(take(changes, map, {3, 5, 97, 95}), (std::vector<CellRect>{{0, 0, 16, 16}, {96, 96, 4, 4}}));
  EXPECT_TRUE(take(changes, map, {3, 5, 97, 95}).empty());
}

TEST(BlockChanges, NeighboursInARowAreOneBlock) {
  OccupancyGrid map(geometryOf(100, 40), kFree);
  BlockChanges changes = sent(map);
  for (const int x : {20, 40, 90}) map[(Cell{x, 20})] = kOccupied;
  EXPECT_EQ(take(changes, map, {20, 20, 71, 1}), (std::vector<CellRect>{{16, 16, 32, 16}, {80, 16, 16, 16}}));
}

TEST(BlockChanges, CellsOutsideOfTheMapAreNoBlocks) {
  BlockChanges changes;
  changes.reset(geometryOf(40, 40));
  EXPECT_TRUE(changes.blocksAround({40, 0, 5, 5}).empty());
  EXPECT_TRUE(changes.blocksAround({}).empty());
  EXPECT_EQ(changes.blocksAround({-10, 35, 100, 100}), (CellRect{0, 32, 40, 8}));
}

TEST(BlockChanges, WhatWasFoundBringsAnyCopyUpToDate) {  // [MUL-1]
  std::mt19937 random(4);
  for (int round = 0; round < 50; ++round) {
    OccupancyGrid map(geometryOf(1 + static_cast<int>(random() % 90), 1 + static_cast<int>(random() % 90)), kUnknown);
    OccupancyGrid copy = map;
    BlockChanges changes = sent(map);
    for (int step = 0; step < 20; ++step) {
      CellRect box;
      for (auto left = random() % 8; left > 0; --left) {
        const Cell cell = map.geometry().cell(random() % map.size());
        map[cell] = static_cast<std::int8_t>(static_cast<int>(random() % 102) - 1);
        box.include(cell);
      }
      for (const CellRect& rect : take(changes, map, box)) {
        for (int y = rect.y; y < rect.y + rect.height; ++y)
          std::copy_n(map.row(y) + rect.x, rect.width, copy.row(y) + rect.x);
      }
      ASSERT_EQ(copy.cells(), map.cells());
    }
  }
}

}  // namespace
}  // namespace frontier_pilot
