#include "ros/mapper/map_message.h"

#include <gtest/gtest.h>
#include <ros/message_traits.h>

#include <vector>

#include "ros/common/messages/conversions.h"

namespace frontier_pilot {
namespace {

occupancy::OccupancyMap someMap() {
  occupancy::OccupancyMap map;
  EXPECT_EQ(map.reserve({-3.0, -2.0}, {17.0, 9.0}), occupancy::MapRoom::kEnough);
  for (int i = 0; i < 150; ++i) {
    map.beginScan();
    map.hit({2 * i, i});
    map.miss({i, 3 * i / 2});
  }
  return map;
}

template <class Message>
std::vector<std::uint8_t> bytesOf(const Message& message) {
  std::vector<std::uint8_t> bytes(ros::serialization::serializationLength(message));
  ros::serialization::OStream stream(bytes.data(), static_cast<std::uint32_t>(bytes.size()));
  ros::serialization::serialize(stream, message);
  EXPECT_EQ(stream.getLength(), 0U);
  return bytes;
}

// [MAP-2]
TEST(MapMessage, IsOnTheWireWhatAnOccupancyGridIs_MAP_2) {
  const occupancy::OccupancyMap map = someMap();
  const MapMessage message(map, "map", timeFromSeconds(3.0));
  nav_msgs::OccupancyGrid grid = toOccupancyGridMsg(map.projection(), "map", Time{});
  grid.header.stamp = message.header.stamp;
  EXPECT_GT(grid.data.size(), 100'000U);
  EXPECT_TRUE(bytesOf(message) == bytesOf(grid));
}

TEST(MapMessage, IsPublishedAsAnOccupancyGrid) {
  const occupancy::OccupancyMap map = someMap();
  const MapMessage message(map, "map", timeFromSeconds(3.0));
  const nav_msgs::OccupancyGrid grid;
  EXPECT_STREQ(ros::message_traits::md5sum(message), ros::message_traits::md5sum(grid));
  EXPECT_STREQ(ros::message_traits::datatype(message), ros::message_traits::datatype(grid));
  EXPECT_STREQ(ros::message_traits::definition(message), ros::message_traits::definition(grid));
}

}  // namespace
}  // namespace frontier_pilot
