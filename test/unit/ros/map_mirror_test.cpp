#include "frontier_pilot/ros/map_mirror.h"

#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <random>

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

TEST(MapMirror, FLT_1_AnUpdateAtTheEndOfAnIntChangesNothing) {  // [FLT-1]
  constexpr int kMost = std::numeric_limits<int>::max();
  MapMirror mirror;
  mirror.handleMap(message(kRoom));
  mirror.takeChanged();
  for (const auto& msg : {update(kMost, 0, 1, 1, kFree), update(0, kMost, 1, 1, kFree), update(kMost, kMost, 2, 2, 50),
                          update(kMost - 1, 1, 3, 1, kOccupied)}) {
    mirror.handleUpdate(msg);
  }
  EXPECT_EQ(mirror.map().cells(), message(kRoom).data);
  EXPECT_TRUE(mirror.takeChanged().empty());
  EXPECT_EQ(mirror.rejections().total(), 4U);
}

TEST(MapMirror, FLT_1_AnUpdateIsTakenExactlyWhereItLiesInTheMapWhateverItsNumbers) {  // [FLT-1]
  constexpr std::array<std::int64_t, 12> kEdges = {0, 1, 2, 3, 4, 5, 6, -1, 65536, 1 << 30, 2147483647, 4294967295};
  std::mt19937 random(3);
  const auto edge = [&] { return kEdges[random() % kEdges.size()]; };
  MapMirror mirror;
  mirror.handleMap(message(kRoom));
  int taken = 0;
  for (int i = 0; i < 100000; ++i) {
    map_msgs::OccupancyGridUpdate msg;
    msg.x = static_cast<std::int32_t>(edge());
    msg.y = static_cast<std::int32_t>(edge());
    msg.width = static_cast<std::uint32_t>(edge());
    msg.height = static_cast<std::uint32_t>(edge());
    msg.data.assign(random() % 25, kFree);
    const bool fits = msg.x >= 0 && msg.y >= 0 && !msg.data.empty() &&
                      msg.data.size() == std::uint64_t{msg.width} * msg.height &&
                      std::int64_t{msg.x} + msg.width <= 5 && std::int64_t{msg.y} + msg.height <= 4;
    const auto before = mirror.rejections().total();
    mirror.handleUpdate(msg);
    ASSERT_EQ(mirror.rejections().total() == before, fits) << msg;
    taken += fits ? 1 : 0;
  }
  EXPECT_GT(taken, 10);
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
