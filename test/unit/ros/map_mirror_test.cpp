#include "frontier_pilot/ros/map_mirror.h"

#include <gtest/gtest.h>

#include "frontier_pilot/ros/conversions.h"
#include "support/ascii_world.h"

namespace frontier_pilot {
namespace {

nav_msgs::OccupancyGrid message(const std::string& drawing) {
  return toOccupancyGridMsg(test::drawWorld(drawing).map, "map", Time{});
}

map_msgs::OccupancyGridUpdate update(int x, int y, std::uint32_t width, std::uint32_t height, std::int8_t value) {
  map_msgs::OccupancyGridUpdate msg;
  msg.x = x;
  msg.y = y;
  msg.width = width;
  msg.height = height;
  msg.data.assign(static_cast<std::size_t>(width) * height, value);
  return msg;
}

const char* const kRoom = "#####\n#...#\n#...#\n#####";

TEST(MapMirror, SaysThatEverythingIsNewAtFirst) {
  MapMirror mirror;
  EXPECT_FALSE(mirror.ready());
  EXPECT_TRUE(mirror.takeChanged().empty());
  mirror.handleMap(message(kRoom));
  EXPECT_TRUE(mirror.ready());
  EXPECT_EQ(mirror.takeChanged(), (CellRect{0, 0, 5, 4}));
  EXPECT_TRUE(mirror.takeChanged().empty());
}

TEST(MapMirror, FindsTheDifferenceOfAFullMap) {
  MapMirror mirror;
  mirror.handleMap(message(kRoom));
  mirror.takeChanged();
  mirror.handleMap(message(kRoom));
  EXPECT_TRUE(mirror.takeChanged().empty());
  mirror.handleMap(message("#####\n#..##\n##..#\n#####"));
  EXPECT_EQ(mirror.takeChanged(), (CellRect{1, 1, 3, 2}));
}

TEST(MapMirror, TakesUpdatesAndJoinsTheirBlocks) {
  MapMirror mirror;
  mirror.handleMap(message(kRoom));
  mirror.takeChanged();
  mirror.handleUpdate(update(1, 1, 1, 1, kOccupied));
  mirror.handleUpdate(update(3, 2, 1, 1, kUnknown));
  EXPECT_EQ(mirror.map()[(Cell{1, 1})], kOccupied);
  EXPECT_EQ(mirror.map()[(Cell{3, 2})], kUnknown);
  EXPECT_EQ(mirror.takeChanged(), (CellRect{1, 1, 3, 2}));
}

TEST(MapMirror, KeepsWhatItHasWhenAMapOrAnUpdateIsMalformed) {
  MapMirror mirror;
  mirror.handleMap(message(kRoom));
  mirror.takeChanged();
  nav_msgs::OccupancyGrid broken = message(kRoom);
  broken.data.pop_back();
  mirror.handleMap(broken);
  mirror.handleMap(nav_msgs::OccupancyGrid());
  mirror.handleUpdate(update(4, 3, 2, 1, kFree));
  mirror.handleUpdate(update(-1, 0, 1, 1, kFree));
  EXPECT_EQ(mirror.map().cells(), message(kRoom).data);
  EXPECT_TRUE(mirror.takeChanged().empty());
  EXPECT_EQ(mirror.rejections().total(), 4U);
}

TEST(MapMirror, TakesASmallerMapWhole) {
  MapMirror mirror;
  mirror.handleMap(message(kRoom));
  mirror.takeChanged();
  mirror.handleMap(message("###\n#.#\n###"));
  EXPECT_EQ(mirror.map().width(), 3);
  EXPECT_EQ(mirror.takeChanged(), (CellRect{0, 0, 3, 3}));
}

TEST(MapMirror, IgnoresAnUpdateBeforeTheFirstMap) {
  MapMirror mirror;
  mirror.handleUpdate(update(0, 0, 1, 1, kFree));
  EXPECT_FALSE(mirror.ready());
  EXPECT_EQ(mirror.rejections().total(), 0U);
}

}  // namespace
}  // namespace frontier_pilot
