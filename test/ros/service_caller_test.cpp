// The window's calls of services, without a window.
#include "ros/teleop_gui/service_caller.h"

#include <gtest/gtest.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <std_srvs/Trigger.h>

#include <atomic>
#include <functional>
#include <mutex>
#include <optional>

#include "ros/common/publish_flush.h"

namespace frontier_pilot {
namespace {

bool waitFor(const std::function<bool()>& condition) {
  const ros::WallTime end = ros::WallTime::now() + ros::WallDuration(15.0);
  while (!condition() && ros::WallTime::now() < end) {
    ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(0.02));
  }
  return condition();
}

// [GUI-2] Pressed between the death of an arbiter and its return.
TEST(ServiceCallerOnTheWire, AStopIsAskedForAgainUntilThereIsSomebodyToAnswerOrItIsWithdrawn) {
  std::atomic<int> calls{0};
  const boost::function<bool(std_srvs::Trigger::Request&, std_srvs::Trigger::Response&)> handle =
      [&calls](std_srvs::Trigger::Request&, std_srvs::Trigger::Response& response) {
        ++calls;
        return response.success = 1;
      };
  ros::NodeHandle node;
  std::atomic<int> lines{0};
  ServiceCaller caller(node, [&lines](teleop::Severity, const std::string&) { ++lines; });
  caller.insist("late_stop");
  EXPECT_TRUE(waitFor([&] { return lines == 1; })) << "it says that it tries again";
  ros::ServiceServer late = node.advertiseService("late_stop", handle);
  EXPECT_TRUE(waitFor([&] { return calls == 1 && lines == 2; }));
  late.shutdown();
  caller.insist("late_stop");
  EXPECT_TRUE(waitFor([&] { return lines == 3; }));
  caller.withdraw();
  EXPECT_TRUE(waitFor([&] { return lines == 4; })) << "it says that there was no answer";
  late = node.advertiseService("late_stop", handle);
  const ros::WallTime begin = ros::WallTime::now();
  EXPECT_TRUE(waitFor([&] { return ros::WallTime::now() - begin > ros::WallDuration(1.0); }));
  EXPECT_EQ(calls, 1);
}

// [ARB-7] [GUI-2] The stop holds, but the robot may still drive.
TEST(ServiceCallerOnTheWire, AStopWhoseZeroMayNotHaveBeenSentYetIsAWarning_ARB_7_GUI_2) {
  bool sent = false;
  const boost::function<bool(std_srvs::Trigger::Request&, std_srvs::Trigger::Response&)> handle =
      [&sent](std_srvs::Trigger::Request&, std_srvs::Trigger::Response& response) {
        response.message = answerOfStop("stopped", sent);
        return response.success = 1;
      };
  ros::NodeHandle node;
  const ros::ServiceServer server = node.advertiseService("a_stop", handle);
  std::mutex mutex;
  std::optional<teleop::Severity> severity;
  ServiceCaller caller(node, [&](teleop::Severity of_line, const std::string&) {
    const std::lock_guard<std::mutex> lock(mutex);
    severity = of_line;
  });
  const auto isLogged = [&](teleop::Severity expected) {
    caller.trigger("a_stop");
    return waitFor([&] {
      const std::lock_guard<std::mutex> lock(mutex);
      return severity == expected;
    });
  };
  EXPECT_TRUE(isLogged(teleop::Severity::kWarning));
  sent = true;
  EXPECT_TRUE(isLogged(teleop::Severity::kGood));
}

}  // namespace
}  // namespace frontier_pilot

int main(int argc, char** argv) {
  ::testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "service_caller_test");
  const ros::NodeHandle node;
  return RUN_ALL_TESTS();
}
