#include "ros/common/messages/checked_subscription.h"

#include <gtest/gtest.h>
#include <nav_msgs/Path.h>
#include <sensor_msgs/LaserScan.h>
#include <tf2_msgs/TFMessage.h>

#include <cstring>

namespace frontier_pilot {
namespace {

template <class Msg>
std::vector<std::uint8_t> bytesOf(const Msg& msg) {
  std::vector<std::uint8_t> bytes(ros::serialization::serializationLength(msg));
  ros::serialization::OStream stream(bytes.data(), static_cast<std::uint32_t>(bytes.size()));
  ros::serialization::serialize(stream, msg);
  return bytes;
}

template <class Msg>
Msg read(std::vector<std::uint8_t> bytes) {
  Msg msg;
  CheckedStream(bytes.data(), static_cast<std::uint32_t>(bytes.size())).next(msg);
  return msg;
}

template <class Msg>
void expectReadAsWritten(const Msg& msg) {
  EXPECT_EQ(bytesOf(read<Msg>(bytesOf(msg))), bytesOf(msg));
}

sensor_msgs::LaserScan scan() {
  sensor_msgs::LaserScan msg;
  msg.header.frame_id = "base_scan";
  msg.ranges = {1.0F, 2.0F, 3.0F};
  return msg;
}

// [FLT-1]
TEST(CheckedStream, FLT_1_ReadsWhatRoscppWrites) {
  expectReadAsWritten(scan());
  tf2_msgs::TFMessage transforms;
  transforms.transforms.resize(3);
  transforms.transforms[1].child_frame_id = "base_footprint";
  expectReadAsWritten(transforms);
  nav_msgs::Path path;
  path.poses.resize(2);
  path.poses[1].pose.orientation.w = 1.0;
  expectReadAsWritten(path);
  expectReadAsWritten(nav_msgs::Path());
}

// [FLT-1]
TEST(CheckedStream, FLT_1_AnArrayThatSaysItIsLongerThanItsMessageIsRefusedBeforeThereIsRoomForIt) {
  std::vector<std::uint8_t> bytes = bytesOf(scan());
  // The number of ranges stands before the ranges and the number of intensities, which is zero.
  const std::size_t at = bytes.size() - 4 - 3 * sizeof(float) - 4;
  for (const std::uint32_t count : {4U, 0x40000000U, 0x7fffffffU, 0xffffffffU}) {
    std::memcpy(bytes.data() + at, &count, sizeof(count));
    EXPECT_THROW(read<sensor_msgs::LaserScan>(bytes), ros::serialization::StreamOverrunException) << count;
  }
  std::vector<std::uint8_t> transforms = {0xff, 0xff, 0xff, 0x7f};
  EXPECT_THROW(read<tf2_msgs::TFMessage>(transforms), ros::serialization::StreamOverrunException);
}

// [FLT-1]
TEST(CheckedStream, FLT_1_AMessageThatIsCutAnywhereIsRefused) {
  const std::vector<std::uint8_t> whole = bytesOf(scan());
  for (std::size_t size = 0; size < whole.size(); ++size) {
    const std::vector<std::uint8_t> cut(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size));
    EXPECT_THROW(read<sensor_msgs::LaserScan>(cut), ros::serialization::StreamOverrunException) << size;
  }
}

/// What a subscription makes of some bytes: whether there is a message, and what of it comes to `unreadable`.
template <class Msg>
bool isRead(std::vector<std::uint8_t> bytes, UnreadableMessages& unreadable) {
  const boost::function<void(const ros::MessageEvent<const Msg>&)> handle = [](const auto&) {};
  const ros::SubscribeOptions options = checkedSubscription<Msg>("scan", 1, unreadable, handle);
  ros::SubscriptionCallbackHelperDeserializeParams params;
  params.buffer = bytes.data();
  params.length = static_cast<std::uint32_t>(bytes.size());
  return options.helper->deserialize(params) != nullptr;
}

// [FLT-1] What is thrown to roscpp here it logs, a line for each message.
TEST(CheckedSubscription, FLT_1_WhatCannotBeReadIsNoMessageAndIsCountedByReason) {
  UnreadableMessages unreadable;
  EXPECT_TRUE(isRead<sensor_msgs::LaserScan>(bytesOf(scan()), unreadable));
  EXPECT_EQ(unreadable.total(), 0U);
  for (int i = 0; i < 3; ++i) {
    EXPECT_NO_THROW(EXPECT_FALSE(isRead<sensor_msgs::LaserScan>({'a', 'b', 'c'}, unreadable)));
  }
  EXPECT_EQ(unreadable.total(), 3U);
  diagnostic_updater::DiagnosticStatusWrapper status;
  unreadable.report(status);
  ASSERT_EQ(status.values.size(), 2U);
  EXPECT_EQ(status.values[1].key, "message of scan refused: shorter than its fields");
  EXPECT_EQ(status.values[1].value, "3");
}

}  // namespace
}  // namespace frontier_pilot
