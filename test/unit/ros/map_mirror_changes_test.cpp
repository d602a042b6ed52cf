// MapMirror with `map_changes`: one connection, whose messages are in order.
#include <gtest/gtest.h>

#include "ros/common/messages/conversions.h"
#include "ros/common/messages/map_mirror.h"
#include "unit/ros/map_changes_message.h"

namespace frontier_pilot {
namespace {

using test::changedBlock;
using test::wholeMap;

std::vector<std::int8_t> cellsOf(const std::string& drawing) { return test::drawWorld(drawing).map.cells(); }

nav_msgs::OccupancyGrid plainMap(const std::string& drawing, double seconds = 0.0) {
  return toOccupancyGridMsg(test::drawWorld(drawing).map, "map", timeFromSeconds(seconds));
}

map_msgs::OccupancyGridUpdate plainUpdate(Cell cell, std::int8_t value, double seconds = 0.0) {
  map_msgs::OccupancyGridUpdate msg;
  msg.header.stamp = toRosTime(timeFromSeconds(seconds));
  msg.x = cell.x;
  msg.y = cell.y;
  msg.width = msg.height = 1;
  msg.data = {value};
  return msg;
}

TEST(MapMirrorOfChanges, SaysThatEverythingIsNewAtFirstAndFindsTheDifferenceOfAFullMap) {  // [MUL-1]
  MapMirror mirror;
  mirror.handleChanges(wholeMap(test::kRoom, 7, 3.0));
  EXPECT_TRUE(mirror.ready());
  EXPECT_EQ(mirror.map().cells(), cellsOf(test::kRoom));
  EXPECT_EQ(mirror.stamp(), timeFromSeconds(3.0));
  EXPECT_EQ(mirror.frame(), "map");
  EXPECT_EQ(mirror.takeChanged(), (CellRect{0, 0, 5, 4}));
  mirror.handleChanges(wholeMap(test::kRoom, 8));
  EXPECT_TRUE(mirror.takeChanged().empty());
  mirror.handleChanges(wholeMap("#####\n#..##\n##..#\n#####", 9));
  EXPECT_EQ(mirror.takeChanged(), (CellRect{1, 1, 3, 2}));
  EXPECT_FALSE(mirror.lacksChanges());
}

TEST(MapMirrorOfChanges, TakesChangesAndJoinsTheirBlocks) {  // [MUL-1]
  MapMirror mirror;
  mirror.handleChanges(wholeMap(test::kRoom, 1));
  mirror.takeChanged();
  mirror.handleChanges(changedBlock(test::kRoom, 2, {1, 1, 1, 1}, kOccupied));
  mirror.handleChanges(changedBlock(test::kRoom, 3, {3, 2, 1, 1}, kUnknown, 4.0));
  EXPECT_EQ(mirror.map()[(Cell{1, 1})], kOccupied);
  EXPECT_EQ(mirror.map()[(Cell{3, 2})], kUnknown);
  EXPECT_EQ(mirror.takeChanged(), (CellRect{1, 1, 3, 2}));
  EXPECT_EQ(mirror.stamp(), timeFromSeconds(4.0));
  EXPECT_FALSE(mirror.lacksChanges());
}

TEST(MapMirrorOfChanges, FLT_1_KeepsWhatItHasWhenAMessageIsMalformedOrInAWrongFrame) {  // [FLT-1]
  MapMirror mirror;
  mirror.handleChanges(wholeMap(test::kRoom, 1));
  mirror.takeChanged();
  MapChanges broken = wholeMap(test::kRoom, 2);
  broken.runs.pop_back();
  mirror.handleChanges(broken);
  mirror.handleChanges(MapChanges());
  mirror.handleChanges(changedBlock(test::kRoom, 2, {4, 3, 2, 1}, kFree));
  mirror.handleChanges(changedBlock("###\n#.#\n###", 2, {1, 1, 1, 1}, kOccupied));
  EXPECT_EQ(mirror.map().cells(), cellsOf(test::kRoom));
  EXPECT_TRUE(mirror.takeChanged().empty());
  EXPECT_EQ(mirror.rejections().total(), 4U);
}

TEST(MapMirrorOfChanges, TakesASmallerMapWhole) {
  MapMirror mirror;
  mirror.handleChanges(wholeMap(test::kRoom, 1));
  mirror.takeChanged();
  mirror.handleChanges(wholeMap("###\n#.#\n###", 2));
  EXPECT_EQ(mirror.map().width(), 3);
  EXPECT_EQ(mirror.takeChanged(), (CellRect{0, 0, 3, 3}));
}

TEST(MapMirrorOfChanges, IgnoresChangesBeforeTheFirstWholeMap) {
  MapMirror mirror;
  mirror.handleChanges(changedBlock(test::kRoom, 1, {1, 1, 1, 1}, kOccupied));
  EXPECT_FALSE(mirror.ready());
  mirror.handleMap(plainMap(test::kRoom));
  mirror.handleChanges(changedBlock(test::kRoom, 2, {1, 1, 1, 1}, kOccupied));
  EXPECT_EQ(mirror.map().cells(), cellsOf(test::kRoom)) << "which `map` has or has not in it";
  EXPECT_EQ(mirror.rejections().total(), 0U);
}

TEST(MapMirrorOfChanges, NoticesThatAMessageWasLostUntilAWholeMapComes) {  // [FLT-1] [MUL-1]
  MapMirror mirror;
  mirror.handleChanges(wholeMap(test::kRoom, 4294967294U));
  mirror.handleChanges(changedBlock(test::kRoom, 4294967295U, {1, 1, 1, 1}, kOccupied));
  mirror.handleChanges(changedBlock(test::kRoom, 0, {1, 2, 1, 1}, kOccupied));
  EXPECT_FALSE(mirror.lacksChanges()) << "the number begins again";
  mirror.handleChanges(changedBlock(test::kRoom, 2, {3, 2, 1, 1}, kOccupied));
  EXPECT_TRUE(mirror.lacksChanges());
  EXPECT_EQ(mirror.map()[(Cell{3, 2})], kOccupied) << "what has come is right nevertheless";
  mirror.handleChanges(changedBlock(test::kRoom, 3, {3, 1, 1, 1}, kOccupied));
  EXPECT_TRUE(mirror.lacksChanges());
  mirror.handleChanges(wholeMap(test::kRoom, 4));
  EXPECT_FALSE(mirror.lacksChanges());
}

TEST(MapMirrorOfChanges, ChangesOfAMapThatHasGrownAreNotWrittenIntoTheSmallerOne) {  // [FLT-1]
  MapMirror mirror;
  mirror.handleChanges(wholeMap("###\n#.#\n###", 1));
  mirror.handleChanges(changedBlock(test::kRoom, 2, {1, 1, 1, 1}, kOccupied));
  EXPECT_EQ(mirror.map().cells(), cellsOf("###\n#.#\n###"));
  EXPECT_TRUE(mirror.lacksChanges());
}

TEST(MapMirrorOfChanges, StampsMakeNoDifferenceBecauseOneConnectionIsInOrder) {  // [MAP-2]
  MapMirror mirror;
  mirror.handleChanges(wholeMap(test::kRoom, 1, 100.0));
  mirror.handleChanges(changedBlock(test::kRoom, 2, {1, 1, 1, 1}, kOccupied, 200.0));
  mirror.handleChanges(changedBlock(test::kRoom, 3, {2, 1, 1, 1}, kOccupied, 50.0));  // the clock was set back
  mirror.handleChanges(changedBlock(test::kRoom, 4, {3, 1, 1, 1}, kOccupied, 0.0));
  for (const int x : {1, 2, 3}) EXPECT_EQ(mirror.map()[(Cell{x, 1})], kOccupied) << x;
  mirror.handleChanges(wholeMap(test::kRoom, 5, 49.0));
  EXPECT_EQ(mirror.map().cells(), cellsOf(test::kRoom));
}

TEST(MapMirrorOfChanges, WhatTheOwnerStillSendsByTheOtherTopicsIsLeftAside) {  // [MUL-1]
  MapMirror mirror;
  mirror.handleMap(plainMap(test::kRoom, 10.0), "/mapper");
  mirror.handleUpdate(plainUpdate({1, 1}, kOccupied, 11.0), "/mapper");
  mirror.handleChanges(wholeMap(test::kRoom, 1, 12.0), "/mapper");
  mirror.takeChanged();
  mirror.handleUpdate(plainUpdate({1, 1}, kOccupied, 11.0), "/mapper");  // was under way
  mirror.handleMap(plainMap("###\n#.#\n###", 10.0), "/mapper");
  EXPECT_EQ(mirror.map().cells(), cellsOf(test::kRoom));
  EXPECT_TRUE(mirror.takeChanged().empty());
  EXPECT_EQ(mirror.rejections().total(), 0U) << "nothing is wrong with it";
}

TEST(MapMirrorOfChanges, FLT_1_ChangesOfAnotherNodeThanTheOwnerAreRefusedByItsName) {  // [FLT-1]
  MapMirror mirror;
  mirror.handleChanges(wholeMap(test::kRoom, 1), "/one");
  mirror.handleChanges(changedBlock(test::kRoom, 2, {1, 1, 1, 1}, kOccupied), "/two");
  mirror.handleUpdate(plainUpdate({1, 1}, kOccupied), "/two");
  EXPECT_EQ(mirror.map().cells(), cellsOf(test::kRoom));
  EXPECT_EQ(mirror.rejections().total(), 2U);
  EXPECT_EQ(mirror.rejections().last(), "from /two, while /one publishes the map");
  EXPECT_FALSE(mirror.lacksChanges());
}

TEST(MapMirrorOfChanges, AnotherPublisherTakesOverByWhicheverTopicsItSends) {  // [FLT-1]
  MapMirror mirror;
  mirror.handleChanges(wholeMap(test::kRoom, 1, 100.0), "/one");
  mirror.handleMap(plainMap("###\n#.#\n###", 50.0), "/foreign");
  EXPECT_EQ(mirror.map().width(), 3);
  mirror.handleUpdate(plainUpdate({1, 1}, kOccupied, 51.0), "/foreign");
  EXPECT_EQ(mirror.map()[(Cell{1, 1})], kOccupied);
  mirror.handleChanges(wholeMap(test::kRoom, 1, 10.0), "/two");
  mirror.handleChanges(changedBlock(test::kRoom, 2, {1, 1, 1, 1}, kOccupied, 11.0), "/two");
  EXPECT_EQ(mirror.map()[(Cell{1, 1})], kOccupied);
  EXPECT_EQ(mirror.rejections().total(), 0U);
}

}  // namespace
}  // namespace frontier_pilot
