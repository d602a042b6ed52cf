#include "ros/common/maps/map_changes.h"

#include <gtest/gtest.h>

#include <random>

#include "frontier_pilot/core/bounds.h"
#include "unit/ros/map_changes_message.h"

namespace frontier_pilot {
namespace {

std::string problemOf(const MapChanges& msg) {
  std::string why;
  return CheckedMapChanges::check(msg, &why) ? "" : why;
}

TEST(CheckedMapChanges, AWholeMapIsTheMapThatWasSent) {  // [MUL-1]
  const MapChanges msg = test::wholeMap(test::kRoom);
  const auto checked = CheckedMapChanges::check(msg, nullptr);
  ASSERT_TRUE(checked && checked->isWhole());
  EXPECT_EQ(checked->whole().cells(), test::drawWorld(test::kRoom).map.cells());
}

TEST(CheckedMapChanges, BlocksAreWrittenWhereTheyLieAndOnlyOtherValuesCountAsChanged) {  // [MUL-1]
  OccupancyGrid map = test::drawWorld(test::kRoom).map;
  MapChanges msg = test::changedBlock(test::kRoom, 1, {0, 0, 5, 2}, kOccupied);
  test::addBlock(msg, {1, 2, 1, 1}, kFree);
  const auto checked = CheckedMapChanges::check(msg, nullptr);
  ASSERT_TRUE(checked && !checked->isWhole());
  EXPECT_EQ(checked->applyTo(map), (CellRect{1, 1, 3, 1}));
  EXPECT_EQ(map.cells(), test::drawWorld("#####\n#...#\n#####\n#####").map.cells());
  EXPECT_TRUE(checked->applyTo(map).empty());
}

TEST(CheckedMapChanges, FLT_1_WhatIsMalformedIsRefusedWithTheReason) {  // [FLT-1]
  const MapChanges whole = test::wholeMap(test::kRoom);
  MapChanges msg = whole;
  msg.info.width = 6;
  EXPECT_EQ(problemOf(msg), "runs malformed, or not as many cells as the blocks have");
  msg = whole;
  msg.runs.pop_back();
  EXPECT_EQ(problemOf(msg), "runs malformed, or not as many cells as the blocks have");
  msg = test::changedBlock(test::kRoom, 1, {1, 1, 1, 1}, kFree);
  msg.whole = 1;
  EXPECT_EQ(problemOf(msg), "blocks in a whole map");
  EXPECT_EQ(problemOf(test::changedBlock(test::kRoom, 1, {4, 3, 2, 1}, kFree)), "block reaches beyond the map");
  EXPECT_EQ(problemOf(test::changedBlock(test::kRoom, 1, {65535, 65535, 65535, 1}, kFree)),
            "block reaches beyond the map");
  EXPECT_EQ(problemOf(test::changedBlock(test::kRoom, 1, {1, 1, 0, 1}, kFree)), "block empty");
  EXPECT_EQ(problemOf(MapChanges()).substr(0, 10), "resolution");
  msg = whole;
  msg.info.width = 0;
  EXPECT_EQ(problemOf(msg), "map empty");
}

TEST(CheckedMapChanges, FLT_1_AMessageOfAFewBytesCannotStandForMoreThanTheLargestMap) {  // [FLT-1]
  MapChanges msg = test::wholeMap(test::kRoom);
  msg.runs = {0x3F, 0xFF, 0xFF, 0xFF, 0xFF};
  msg.info.width = msg.info.height = 65536;
  EXPECT_EQ(problemOf(msg), "map of more than 20000 cells along a side");
  msg.info.width = msg.info.height = 20000;
  EXPECT_EQ(problemOf(msg).substr(0, 31), "map of more than 40000000 cells");
  msg.info.width = msg.info.height = 6000;
  EXPECT_EQ(problemOf(msg), "runs malformed, or not as many cells as the blocks have");
}

TEST(CheckedMapChanges, FLT_1_BlocksThatOverlapCannotStandForMoreCellsThanTheMapHas) {  // [FLT-1]
  MapChanges msg = test::changedBlock(test::kRoom, 1, {0, 0, 5, 4}, kFree);
  EXPECT_EQ(problemOf(msg), "");
  test::addBlock(msg, {0, 0, 1, 1}, kFree);
  EXPECT_EQ(problemOf(msg), "blocks of more cells than the map has");
}

TEST(CheckedMapChanges, FLT_1_WhateverTheNumbersAMessageIsRefusedOrChangesOnlyItsBlocks) {  // [FLT-1]
  std::mt19937 random(5);
  int taken = 0;
  for (int i = 0; i < 50000; ++i) {
    MapChanges msg = test::emptyChanges(test::drawWorld(test::kRoom).map.geometry(), 1, 0.0);
    const auto edge = [&] { return static_cast<std::uint16_t>(random() % 20 == 0 ? 65535 : random() % 4); };
    CellRect box;
    for (auto blocks = 1 + random() % 2; blocks > 0; --blocks) {
      MapBlock block;
      block.x = edge();
      block.y = edge();
      block.width = edge();
      block.height = edge();
      msg.blocks.push_back(block);
      box.include(CellRect{block.x, block.y, block.width, block.height});
    }
    for (auto runs = 1 + random() % 2; runs > 0; --runs)
      msg.runs.push_back(static_cast<std::uint8_t>((random() % 3) << 6 | random() % 8));
    const auto checked = CheckedMapChanges::check(msg, nullptr);
    if (!checked) continue;
    ++taken;
    OccupancyGrid map = test::drawWorld(test::kRoom).map;
    const OccupancyGrid before = map;
    const CellRect changed = checked->applyTo(map);
    ASSERT_TRUE(changed.empty() || changed.intersection(box) == changed);
    CellRect all = changed;
    all.include(difference(before, map));
    ASSERT_EQ(all, changed) << "blocks that overlap may undo each other";
  }
  EXPECT_GT(taken, 300);
}

}  // namespace
}  // namespace frontier_pilot
