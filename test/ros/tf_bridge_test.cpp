// What the bridge says on /tf.

#include "frontier_pilot/ros/tf_bridge.h"

#include <gtest/gtest.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <tf2_msgs/TFMessage.h>

#include <string>
#include <utility>
#include <vector>

#include "frontier_pilot/ros/clock.h"
#include "frontier_pilot/ros/conversions.h"

namespace frontier_pilot {
namespace {

constexpr Duration kSecond = std::chrono::seconds(1);

// A timer that catches up with a simulated clock ticks several times at one time; TF would warn of each.
TEST(TfBridge, SaysATransformOnceAStampAlsoAfterTheClockWasSetBack) {
  using Said = std::vector<std::pair<std::string, Time>>;
  ros::NodeHandle node;
  TfBridge bridge;
  Said said;
  const ros::Subscriber listener = node.subscribe<tf2_msgs::TFMessage>("/tf", 100, [&](const auto& msg) {
    for (const auto& transform : msg->transforms) {
      said.emplace_back(transform.child_frame_id, toTime(transform.header.stamp));
    }
  });
  const auto serveUntilSaid = [&](const char* source) {
    const SteadyTime end = steadyNow() + 10 * kSecond;
    while (steadyNow() < end && (said.empty() || said.back().first != source)) {
      ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(0.05));
    }
    return !said.empty() && said.back().first == source;
  };
  const Time now = Time{} + 100 * kSecond;
  bridge.broadcast("map", "first", {}, now);
  ASSERT_TRUE(serveUntilSaid("first")) << "the listener is connected";
  said.clear();
  const Said wanted = {{"odom", now}, {"base", now}, {"odom", now + kSecond}, {"odom", now}, {"last", now}};
  for (const auto& [source, stamp] : wanted) {
    bridge.broadcast("map", source, {}, stamp);
    bridge.broadcast("map", source, {1.0, 0.0, 0.0}, stamp);
  }
  ASSERT_TRUE(serveUntilSaid("last"));
  EXPECT_EQ(said, wanted);
}

}  // namespace
}  // namespace frontier_pilot

int main(int argc, char** argv) {
  ::testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "tf_bridge_test");
  const ros::NodeHandle keeps_ros_alive;
  return RUN_ALL_TESTS();
}
