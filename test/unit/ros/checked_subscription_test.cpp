#include "ros/common/messages/checked_subscription.h"

#include <gtest/gtest.h>
#include <nav_msgs/Path.h>
#include <ros/message_deserializer.h>
#include <sensor_msgs/LaserScan.h>
#include <tf2_msgs/TFMessage.h>

#include <algorithm>
#include <boost/make_shared.hpp>
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

/// A subscription to messages of one topic, and how many of them came to its callback.
template <class Msg>
class Reader {
 public:
  explicit Reader(UnreadableMessages& unreadable)
      : options_(checkedSubscription<Msg>("scan", 1, unreadable,
                                          [this](const ros::MessageEvent<const Msg>&) { ++read_; })) {}

  /// As roscpp does with the message of a publisher.
  void take(ros::MessageDeserializer& message) {
    const ros::VoidConstPtr msg = message.deserialize();
    if (!msg) return;
    ros::SubscriptionCallbackHelperCallParams params;
    params.event = ros::MessageEvent<const void>(msg, message.getConnectionHeader(), ros::Time(), false,
                                                 ros::MessageEvent<const void>::CreateFunction());
    options_.helper->call(params);
  }
  const ros::SubscriptionCallbackHelperPtr& helper() const { return options_.helper; }
  int read() const { return read_; }

 private:
  int read_ = 0;
  ros::SubscribeOptions options_;
};

/// What a subscription makes of some bytes: whether there is a message, and what of it comes to `unreadable`.
template <class Msg>
bool isRead(const std::vector<std::uint8_t>& bytes, UnreadableMessages& unreadable) {
  Reader<Msg> reader(unreadable);
  ros::SerializedMessage sent(boost::shared_array<std::uint8_t>(new std::uint8_t[bytes.size()]), bytes.size());
  std::copy(bytes.begin(), bytes.end(), sent.buf.get());
  sent.message_start = sent.buf.get();
  ros::MessageDeserializer message(reader.helper(), sent, boost::make_shared<ros::M_string>());
  reader.take(message);
  return reader.read() == 1;
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

// [FLT-1] roscpp deserializes an empty message once for each callback of the topic, and has freed its bytes by the
// second.
TEST(CheckedSubscription, FLT_1_AnEmptyMessageIsNoMessageToTheSecondCallbackEither) {
  const std::vector<std::uint8_t> freed = bytesOf(scan());
  ros::SerializedMessage sent(boost::shared_array<std::uint8_t>(new std::uint8_t[freed.size()]), 0);
  const boost::shared_array<std::uint8_t> kept = sent.buf;  // so that the test reads no memory that is not its own
  std::copy(freed.begin(), freed.end(), sent.buf.get());
  sent.message_start = sent.buf.get();
  UnreadableMessages unreadable;
  Reader<sensor_msgs::LaserScan> first(unreadable), second(unreadable);
  ros::MessageDeserializer message(first.helper(), sent, boost::make_shared<ros::M_string>());
  first.take(message);
  second.take(message);
  EXPECT_EQ(first.read(), 0);
  EXPECT_EQ(second.read(), 0);
  EXPECT_EQ(unreadable.total(), 1U);
}

// [FLT-1] roscpp itself listens to /clock, and would make it read an empty message with a helper that is not checked.
TEST(CheckedSubscription, FLT_1_SharesNoMessageWithASubscriptionThatIsNotChecked) {
  UnreadableMessages unreadable;
  const Reader<sensor_msgs::LaserScan> ours(unreadable), another(unreadable);
  ros::SubscribeOptions plain;
  plain.initByFullCallbackType<const ros::MessageEvent<const sensor_msgs::LaserScan>&>("scan", 1, [](const auto&) {});
  EXPECT_TRUE(ours.helper()->getTypeInfo() == another.helper()->getTypeInfo());
  EXPECT_FALSE(ours.helper()->getTypeInfo() == plain.helper->getTypeInfo());
}

}  // namespace
}  // namespace frontier_pilot
