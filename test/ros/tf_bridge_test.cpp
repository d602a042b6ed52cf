// What the bridge says on /tf, and what it makes of what others say there.

#include "ros/common/tf/tf_bridge.h"

#include <gtest/gtest.h>
#include <ros/ros.h>
#include <tf2_msgs/TFMessage.h>

#include <string>
#include <utility>
#include <vector>

#include "ros/common/clock.h"
#include "ros/common/messages/conversions.h"
#include "wait_for.h"

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
    return test::serveUntil([&] { return !said.empty() && said.back().first == source; });
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

geometry_msgs::TransformStamped transform(const std::string& parent, const std::string& child, const ros::Time& stamp) {
  geometry_msgs::TransformStamped msg;
  msg.header.frame_id = parent;
  msg.header.stamp = stamp;
  msg.child_frame_id = child;
  msg.transform.rotation.w = 1.0;
  return msg;
}

/// Whether `bridge` comes to know `T_target_source` within ten seconds.
bool comesToKnow(const TfBridge& bridge, const std::string& target, const std::string& source) {
  return bridge.lookup(target, source, Time{}, 10 * kSecond).has_value();
}

struct Speaker {
  explicit Speaker(const std::string& topic) : publisher(ros::NodeHandle().advertise<tf2_msgs::TFMessage>(topic, 100)) {
    const SteadyTime end = steadyNow() + 10 * kSecond;
    while (steadyNow() < end && publisher.getNumSubscribers() == 0) ros::WallDuration(0.005).sleep();
  }
  void say(const std::vector<geometry_msgs::TransformStamped>& transforms) const {
    tf2_msgs::TFMessage msg;
    msg.transforms = transforms;
    publisher.publish(msg);
  }
  ros::Publisher publisher;
};

std::string reportOf(const TfBridge& bridge) {
  diagnostic_updater::DiagnosticStatusWrapper status;
  bridge.report(status);
  std::string text;
  for (const auto& entry : status.values) text += entry.key + ": " + entry.value + "\n";
  return text;
}

// [FLT-1]
TEST(TfBridge, OutlivesTransformsOfTheEndOfTimeAndSaysWhatItRefused) {
  const TfBridge bridge;
  const ros::Time end_of_time(4294967295U, 999999999U);
  for (const char* topic : {"/tf", "/tf_static"}) {
    const Speaker speaker(topic);
    const std::string child = std::string("child_on") + (topic[3] == '_' ? "_static" : "");
    for (int i = 0; i < 3; ++i) speaker.say({transform("world", child, end_of_time)});
    speaker.say({transform("world", child, ros::Time::now())});
    EXPECT_TRUE(comesToKnow(bridge, "world", child)) << topic;
  }
  EXPECT_NE(reportOf(bridge).find("transform refused: stamp out of range: 6"), std::string::npos) << reportOf(bridge);
}

// [FLT-1]
TEST(TfBridge, FindsNothingAtTimesThatRosDoesNotHave) {
  const TfBridge bridge;
  const Speaker speaker("/tf");
  speaker.say({transform("here", "there", ros::Time::now())});
  ASSERT_TRUE(comesToKnow(bridge, "here", "there"));
  std::string why;
  EXPECT_FALSE(bridge.lookup("here", "there", Time::max(), Duration::zero(), &why));
  EXPECT_NE(why, "");
  EXPECT_FALSE(bridge.lookup("here", "there", toTime(ros::TIME_MAX), Duration::zero(), &why));
}

// [FLT-1]
TEST(TfBridge, KeepsAScannerWhereItIsFixedWhateverComesLater) {
  const TfBridge bridge;
  const Speaker fixed("/tf_static"), moving("/tf");
  fixed.say({transform("base", "fixed_scan", ros::Time::now())});
  ASSERT_TRUE(comesToKnow(bridge, "base", "fixed_scan"));
  ros::WallDuration(10.5).sleep();  // until then they may all be those of a start
  auto turned = transform("base", "fixed_scan", ros::Time::now());
  turned.transform.rotation.z = 1.0;
  turned.transform.rotation.w = 0.0;
  fixed.say({turned});
  moving.say({transform("elsewhere", "fixed_scan", ros::Time::now())});
  fixed.say({transform("base", "after_fixed", ros::Time::now())});
  moving.say({transform("base", "after_moving", ros::Time::now())});
  ASSERT_TRUE(comesToKnow(bridge, "base", "after_fixed"));
  ASSERT_TRUE(comesToKnow(bridge, "base", "after_moving"));
  const auto T_base_scan = bridge.lookup("base", "fixed_scan", Time{});
  ASSERT_TRUE(T_base_scan);
  EXPECT_NEAR(T_base_scan->yaw, 0.0, 1e-9);
  EXPECT_NE(reportOf(bridge).find("'fixed_scan' has another static transform"), std::string::npos) << reportOf(bridge);
}

// [FLT-1]
TEST(TfBridge, DoesNotBelieveEitherOfTwoPlacesInWhichAScannerIsFixedFromTheStart) {
  const TfBridge bridge;
  const Speaker one("/tf_static"), other("/tf_static");
  one.say({transform("base", "disputed_scan", ros::Time::now())});
  ASSERT_TRUE(comesToKnow(bridge, "base", "disputed_scan"));
  auto turned = transform("base", "disputed_scan", ros::Time::now());
  turned.transform.rotation.z = 1.0;
  turned.transform.rotation.w = 0.0;
  other.say({turned, transform("base", "after_turned", ros::Time::now())});
  ASSERT_TRUE(comesToKnow(bridge, "base", "after_turned"));
  EXPECT_FALSE(bridge.lookup("base", "disputed_scan", Time{}));
  EXPECT_NE(reportOf(bridge).find("'disputed_scan' is said to be in two places"), std::string::npos)
      << reportOf(bridge);
}

// [FLT-1]
TEST(TfBridge, KeepsABoundedNumberOfFrames) {
  const TfBridge bridge;
  const Speaker speaker("/tf");
  std::vector<geometry_msgs::TransformStamped> many;
  for (int i = 0; i < 2000; ++i) many.push_back(transform("root", "leaf" + std::to_string(i), ros::Time::now()));
  speaker.say(many);
  speaker.say({transform("root", "leaf1", ros::Time::now())});
  EXPECT_TRUE(comesToKnow(bridge, "leaf1", "leaf998"));
  EXPECT_FALSE(bridge.lookup("root", "leaf1500", Time{}));
  EXPECT_NE(reportOf(bridge).find("beyond the first 1000 of a message"), std::string::npos) << reportOf(bridge);
}

}  // namespace
}  // namespace frontier_pilot

int main(int argc, char** argv) {
  ::testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "tf_bridge_test");
  const ros::NodeHandle keeps_ros_alive;
  return RUN_ALL_TESTS();
}
