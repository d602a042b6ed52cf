#include "ros/common/messages/map_mirror.h"

#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <random>

#include "ros/common/messages/conversions.h"
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

nav_msgs::OccupancyGrid messageAt(double seconds, const std::string& drawing) {
  return toOccupancyGridMsg(test::drawWorld(drawing).map, "map", timeFromSeconds(seconds));
}

map_msgs::OccupancyGridUpdate updateAt(double seconds, int x, int y, std::int8_t value) {
  map_msgs::OccupancyGridUpdate msg = update(x, y, 1, 1, value);
  msg.header.stamp = toRosTime(timeFromSeconds(seconds));
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

// The two topics have a connection each: a map of a megabyte may take a minute over a slow link while updates pass it.

TEST(MapMirror, AFullMapThatWasOvertakenDoesNotUndoNewerUpdates) {  // [MAP-2]
  MapMirror mirror;
  mirror.handleMap(messageAt(10.0, kRoom));
  mirror.handleUpdate(updateAt(11.0, 1, 1, kOccupied));
  mirror.handleUpdate(updateAt(13.0, 2, 1, kOccupied));
  mirror.takeChanged();
  mirror.handleMap(messageAt(12.0, "#####\n#...#\n##.##\n#####"));  // the update of second 11 is in it
  EXPECT_EQ(mirror.map()[(Cell{1, 1})], kOccupied);
  EXPECT_EQ(mirror.map()[(Cell{2, 1})], kOccupied) << "an update of second 13";
  EXPECT_EQ(mirror.map()[(Cell{3, 1})], kOccupied) << "what came with the full map alone";
  EXPECT_EQ(mirror.takeChanged(), (CellRect{3, 1, 1, 1}));
  EXPECT_EQ(mirror.stamp(), timeFromSeconds(13.0));
}

TEST(MapMirror, AnUpdateOlderThanTheMapIsNotAppliedToIt) {
  MapMirror mirror;
  mirror.handleMap(messageAt(10.0, "###\n#.#\n###"));
  mirror.handleMap(messageAt(20.0, kRoom));  // has grown towards the origin: all indices are others
  mirror.takeChanged();
  mirror.handleUpdate(updateAt(19.0, 1, 1, kOccupied));
  EXPECT_EQ(mirror.map()[(Cell{1, 1})], kFree);
  EXPECT_TRUE(mirror.takeChanged().empty());
  EXPECT_EQ(mirror.rejections().total(), 0U) << "nothing is wrong with it";
}

TEST(MapMirror, UpdatesThatCameBeforeTheirMapAreAppliedToIt) {
  MapMirror mirror;
  mirror.handleUpdate(updateAt(9.0, 3, 1, kOccupied));
  mirror.handleUpdate(updateAt(11.0, 1, 1, kOccupied));
  mirror.handleMap(messageAt(10.0, kRoom));
  EXPECT_EQ(mirror.map()[(Cell{1, 1})], kOccupied);
  EXPECT_EQ(mirror.map()[(Cell{3, 1})], kFree) << "it was in the map already";
}

TEST(MapMirror, AnUpdateWithTheStampOfTheMapCountsWhicheverComesFirst) {
  for (const bool update_first : {true, false}) {
    MapMirror mirror;
    mirror.handleMap(messageAt(9.0, kRoom));
    if (update_first) mirror.handleUpdate(updateAt(10.0, 1, 1, kOccupied));
    mirror.handleMap(messageAt(10.0, kRoom));
    if (!update_first) mirror.handleUpdate(updateAt(10.0, 1, 1, kOccupied));
    EXPECT_EQ(mirror.map()[(Cell{1, 1})], kOccupied) << update_first;
  }
}

TEST(MapMirror, AMapperThatStartedOverIsBelievedWhateverItsStamps) {
  MapMirror mirror;
  mirror.handleMap(messageAt(100.0, kRoom));
  mirror.handleUpdate(updateAt(200.0, 1, 1, kOccupied));
  mirror.handleMap(messageAt(50.0, kRoom));  // its clock was set back
  EXPECT_EQ(mirror.map()[(Cell{1, 1})], kFree);
  mirror.handleUpdate(updateAt(51.0, 2, 1, kOccupied));
  EXPECT_EQ(mirror.map()[(Cell{2, 1})], kOccupied);
  mirror.handleMap(messageAt(52.0, kRoom));
  EXPECT_EQ(mirror.map()[(Cell{2, 1})], kFree);
}

TEST(MapMirror, AClockThatWentBackShowsInTheUpdatesAsWell) {
  MapMirror mirror;
  mirror.handleMap(messageAt(100.0, kRoom));
  mirror.handleUpdate(updateAt(200.0, 1, 1, kOccupied));
  mirror.handleUpdate(updateAt(50.0, 2, 1, kOccupied));
  EXPECT_EQ(mirror.map()[(Cell{2, 1})], kOccupied) << "not held against the old map";
  mirror.handleMap(messageAt(49.0, kRoom));
  EXPECT_EQ(mirror.map()[(Cell{1, 1})], kFree) << "what was before the clock went back";
  EXPECT_EQ(mirror.map()[(Cell{2, 1})], kOccupied) << "what was after";
}

TEST(MapMirror, AnotherPublisherIsNotHeldAgainstTheStampsOfTheFirst) {
  MapMirror mirror;
  mirror.handleMap(messageAt(100.0, kRoom), "/one");
  mirror.handleUpdate(updateAt(3700.0, 1, 1, kOccupied), "/one");  // its clock is an hour ahead
  mirror.handleMap(messageAt(110.0, kRoom), "/two");
  EXPECT_EQ(mirror.map()[(Cell{1, 1})], kFree);
  mirror.handleUpdate(updateAt(111.0, 2, 1, kOccupied), "/two");
  EXPECT_EQ(mirror.map()[(Cell{2, 1})], kOccupied);
}

TEST(MapMirror, SaysOnceThatAnotherNodesMapHasReplacedTheOneOfBeforeAndNotAfterARestartOfItsNode) {  // [MAP-5] [FLT-2]
  MapMirror mirror;
  mirror.handleMap(messageAt(100.0, kRoom), "/one");
  mirror.handleMap(messageAt(50.0, kRoom), "/one");
  EXPECT_FALSE(mirror.takeReplaced());
  mirror.handleMap(messageAt(110.0, kRoom), "/two");
  EXPECT_TRUE(mirror.takeReplaced());
  EXPECT_FALSE(mirror.takeReplaced());
}

TEST(MapMirror, AMapWithoutAStampIsTakenAsItIs) {  // as map_server may send it
  MapMirror mirror;
  mirror.handleMap(messageAt(100.0, kRoom));
  mirror.handleUpdate(updateAt(200.0, 1, 1, kOccupied));
  mirror.handleMap(messageAt(0.0, kRoom));
  EXPECT_EQ(mirror.map()[(Cell{1, 1})], kFree);
  mirror.handleUpdate(updateAt(201.0, 2, 1, kOccupied));
  EXPECT_EQ(mirror.map()[(Cell{2, 1})], kOccupied);
  mirror.handleUpdate(update(3, 1, 1, 1, kOccupied));  // no stamp either
  EXPECT_EQ(mirror.map()[(Cell{3, 1})], kOccupied);
}

TEST(MapMirror, DoesNotTakeTheSimulatorsPictureOfTheWorldForTheMapThatIsMissing) {
  const auto said = [](const std::string& topic) {
    return MapMirror().missing({{topic, "nav_msgs/OccupancyGrid", {"/publisher"}, {}}});
  };
  EXPECT_NE(said("/floor").find("/floor"), std::string::npos) << said("/floor");
  EXPECT_EQ(said("/simulator/world").find("world"), std::string::npos) << said("/simulator/world");
}

TEST(MapMirror, RemembersABoundedNumberOfUpdatesAndPrefersItsCopyToAMapOlderThanThose) {
  MapMirror mirror;
  mirror.handleMap(messageAt(10.0, kRoom));
  mirror.handleUpdate(updateAt(12.0, 1, 1, kOccupied));
  for (int i = 0; i < 5000; ++i) mirror.handleUpdate(updateAt(13.0 + 0.001 * i, 2, 1, kOccupied));
  mirror.handleMap(messageAt(11.0, kRoom));
  EXPECT_EQ(mirror.map()[(Cell{1, 1})], kOccupied);
  EXPECT_EQ(mirror.map()[(Cell{2, 1})], kOccupied);
  mirror.handleMap(messageAt(19.0, kRoom));
  EXPECT_EQ(mirror.map()[(Cell{1, 1})], kFree);
}

}  // namespace
}  // namespace frontier_pilot
