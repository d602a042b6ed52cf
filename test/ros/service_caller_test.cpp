// The window's calls of services, without a window.
#include "ros/teleop_gui/service_caller.h"

#include <frontier_pilot/SaveMap.h>
#include <gtest/gtest.h>
#include <ros/master.h>
#include <ros/ros.h>
#include <std_srvs/SetBool.h>
#include <std_srvs/Trigger.h>

#include <atomic>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "hanging_server.h"
#include "ros/common/clock.h"
#include "ros/common/messages/stop_words.h"
#include "wait_for.h"

namespace frontier_pilot {
namespace {

constexpr Duration kPatience = std::chrono::milliseconds(1500);  // for the first answer to a stop

bool waitFor(const std::function<bool()>& condition) { return test::serveUntil(condition, std::chrono::seconds(15)); }

/// What the operator is told.
class Lines {
 public:
  OperatorLog log() {
    return [this](teleop::Severity severity, const std::string& line) {
      const std::lock_guard<std::mutex> lock(mutex_);
      text_ += line + "\n";
      last_ = severity;
    };
  }
  bool have(const std::string& words) {
    const std::lock_guard<std::mutex> lock(mutex_);
    return text_.find(words) != std::string::npos;
  }
  std::optional<teleop::Severity> last() {
    const std::lock_guard<std::mutex> lock(mutex_);
    return last_;
  }

 private:
  std::mutex mutex_;
  std::string text_;
  std::optional<teleop::Severity> last_;
};

using Switch = HangingServer<std_srvs::SetBool>;

/// That nothing more comes can only be seen by waiting.
void letTimePass(double seconds) {
  const ros::WallTime end = ros::WallTime::now() + ros::WallDuration(seconds);
  EXPECT_TRUE(waitFor([end] { return ros::WallTime::now() > end; }));
}

// [GUI-2] Pause, Start, Pause, while the explorer hangs.
TEST(ServiceCallerOnTheWire, TheOppositeOfTheLastWordThatStillWaitsIsNotCarriedOut_GUI_2) {
  Switch explorer("explorer_that_hangs");
  Lines lines;
  ServiceCaller caller(ros::NodeHandle(), lines.log());
  caller.set("explorer_that_hangs", false);
  ASSERT_TRUE(waitFor([&] { return explorer.calls().size() == 1; }));
  caller.set("explorer_that_hangs", true);
  caller.set("explorer_that_hangs", false);
  explorer.free();
  letTimePass(1.0);
  EXPECT_EQ(explorer.calls().size(), 1U) << "it was started after the last word, which was to pause";
  EXPECT_TRUE(lines.have("explorer_that_hangs on is not done: explorer_that_hangs off was asked for after it"));
}

// [GUI-2] [GUI-3]
TEST(ServiceCallerOnTheWire, OfWhatWaitsAtAStopOnlyWhatEndsAMotionIsDone_GUI_2) {
  Switch hanging("first_switch"), start("second_switch"), pause("third_switch");
  start.free();
  pause.free();
  Lines lines;
  ServiceCaller caller(ros::NodeHandle(), lines.log());
  caller.set("first_switch", false);
  ASSERT_TRUE(waitFor([&] { return hanging.calls().size() == 1; }));
  caller.set("second_switch", true);
  caller.set("third_switch", false, ServiceCaller::Late::kDone);
  caller.dropWhatWaits("somebody stopped the robot");
  hanging.free();
  EXPECT_TRUE(waitFor([&] { return pause.calls().size() == 1; }));
  EXPECT_TRUE(start.calls().empty());
  EXPECT_TRUE(lines.have("second_switch on is not done: somebody stopped the robot"));
}

// [GUI-3]
TEST(ServiceCallerOnTheWire, WhatHasWaitedTooLongIsNotDoneWithAWord_GUI_3) {
  Switch hanging("slow_switch"), start("late_switch"), pause("late_pause");
  start.free();
  pause.free();
  Lines lines;
  ServiceCaller caller(ros::NodeHandle(), lines.log());
  caller.set("slow_switch", false);
  ASSERT_TRUE(waitFor([&] { return hanging.calls().size() == 1; }));
  caller.set("late_switch", true);
  caller.set("late_pause", false, ServiceCaller::Late::kDone);
  letTimePass(2.5);
  hanging.free();
  EXPECT_TRUE(waitFor([&] { return pause.calls().size() == 1; }));
  EXPECT_TRUE(start.calls().empty());
  EXPECT_TRUE(lines.have("late_switch on is not done: it has waited too long"));
}

// [GUI-2] The connection may hang for minutes after an outage of the network.
TEST(ServiceCallerOnTheWire, AStopWithoutAnAnswerIsMadeAgainOverAnotherConnection_GUI_2) {
  HangingServer<std_srvs::Trigger> arbiter("stop_that_hangs", HangingServer<std_srvs::Trigger>::Hangs::kOnce);
  Lines lines;
  ServiceCaller caller(ros::NodeHandle(), lines.log());
  const ros::WallTime pressed = ros::WallTime::now();
  caller.insist("stop_that_hangs", kPatience);
  EXPECT_TRUE(waitFor([&] {
    caller.lookAfter(steadyNow());
    return arbiter.calls().size() == 2 && lines.have("stop_that_hangs: done");
  }));
  EXPECT_LT((ros::WallTime::now() - pressed).toSec(), 5.0);
  EXPECT_TRUE(lines.have("stop_that_hangs: it does not answer, trying again"));
}

void waitUntilReady(ServiceCaller& caller, const std::string& service) {
  ASSERT_TRUE(waitFor([&] {
    caller.getReady(service, true);
    return caller.isReady(service);
  }));
}

/// Makes the master forget a service of this node, as one that was started anew has.
void forget(const std::string& service) {
  XmlRpc::XmlRpcValue asked, response, payload;
  asked[0] = ros::this_node::getName();
  asked[1] = service;
  ASSERT_TRUE(ros::master::execute("lookupService", asked, response, payload, false));
  asked[2] = std::string(payload);
  ASSERT_TRUE(ros::master::execute("unregisterService", asked, response, payload, false));
}

// [ARB-12] [GUI-2]
TEST(ServiceCallerOnTheWire, AStopThatWasConnectedToBeforeNeedsNoMaster_ARB_12_GUI_2) {
  HangingServer<std_srvs::Trigger> arbiter("stop_without_master");
  arbiter.free();
  Lines lines;
  ServiceCaller caller(ros::NodeHandle(), lines.log());
  EXPECT_FALSE(caller.isReady("stop_without_master"));
  waitUntilReady(caller, "stop_without_master");
  forget("/stop_without_master");
  caller.getReady("stop_without_master", false);
  for (const std::size_t pressed : {1U, 2U}) {
    caller.insist("stop_without_master", kPatience);
    EXPECT_TRUE(waitFor([&] { return arbiter.calls().size() == pressed; })) << pressed;
  }
  EXPECT_TRUE(waitFor([&] { return lines.have("stop_without_master: done"); }));
  EXPECT_FALSE(lines.have("trying again"));
}

// [GUI-2] The connection that was made before may be one to an arbiter that has ended.
TEST(ServiceCallerOnTheWire, AStopGoesToTheArbiterThatCameAfterTheOneConnectedTo_GUI_2) {
  Lines lines;
  ServiceCaller caller(ros::NodeHandle(), lines.log());
  {
    HangingServer<std_srvs::Trigger> first("stop_of_two");
    waitUntilReady(caller, "stop_of_two");
    caller.getReady("stop_of_two", false);  // seen no more, and the next one is not seen yet
  }
  HangingServer<std_srvs::Trigger> second("stop_of_two");
  second.free();
  caller.insist("stop_of_two", kPatience);
  EXPECT_TRUE(waitFor([&] { return second.calls().size() == 1 && lines.have("stop_of_two: done"); }));
}

// [GUI-2]
TEST(ServiceCallerOnTheWire, AConnectionMadeBeforeThatDoesNotAnswerIsReplaced_GUI_2) {
  HangingServer<std_srvs::Trigger> arbiter("ready_stop_that_hangs", HangingServer<std_srvs::Trigger>::Hangs::kOnce);
  Lines lines;
  ServiceCaller caller(ros::NodeHandle(), lines.log());
  waitUntilReady(caller, "ready_stop_that_hangs");
  caller.getReady("ready_stop_that_hangs", false);
  caller.insist("ready_stop_that_hangs", kPatience);
  EXPECT_TRUE(waitFor([&] {
    caller.lookAfter(steadyNow());
    return arbiter.calls().size() == 2 && lines.have("ready_stop_that_hangs: done");
  }));
}

// [FLT-1]
TEST(ServiceCallerOnTheWire, AMapThatIsNotSavedBecauseAnotherOneWasAskedForIsNamed_FLT_1) {
  HangingServer<SaveMap> mapper("save_that_hangs");
  Lines lines;
  ServiceCaller caller(ros::NodeHandle(), lines.log());
  caller.saveMap("save_that_hangs", "a");
  ASSERT_TRUE(waitFor([&] { return mapper.calls().size() == 1; }));
  caller.saveMap("save_that_hangs", "b");
  caller.saveMap("save_that_hangs", "c");
  EXPECT_TRUE(lines.have("save_that_hangs b is not done: save_that_hangs c was asked for after it"));
  mapper.free();
  EXPECT_TRUE(waitFor([&] { return mapper.calls().size() == 2; }));
  EXPECT_EQ(mapper.calls().back().path, "c");
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
  caller.insist("late_stop", kPatience);
  EXPECT_TRUE(waitFor([&] { return lines == 1; })) << "it says that it tries again";
  ros::ServiceServer late = node.advertiseService("late_stop", handle);
  EXPECT_TRUE(waitFor([&] { return calls == 1 && lines == 2; }));
  late.shutdown();
  caller.insist("late_stop", kPatience);
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

// [ARB-12] [GUI-2] Nothing is latched where another node has taken the service.
TEST(ServiceCallerOnTheWire, AStopThatNoArbiterHasSignedIsAWarning_ARB_12_GUI_2) {
  std::string said = "stopped";
  const boost::function<bool(std_srvs::Trigger::Request&, std_srvs::Trigger::Response&)> handle =
      [&said](std_srvs::Trigger::Request&, std_srvs::Trigger::Response& response) {
        response.message = said;
        return response.success = 1;
      };
  const ros::ServiceServer server = ros::NodeHandle().advertiseService("a_strange_stop", handle);
  Lines lines;
  ServiceCaller caller(ros::NodeHandle(), lines.log());
  caller.insist("a_strange_stop", kPatience, ServiceCaller::Signature::kOfArbiter);
  EXPECT_TRUE(waitFor([&] {
    return lines.have(
        "a_strange_stop: stopped; the answer of a_strange_stop is not signed by an arbiter: make sure that the robot "
        "stands");
  }));
  EXPECT_EQ(lines.last(), teleop::Severity::kWarning);
  said = "stopped (answered by /cmd_vel_arbiter)";
  caller.insist("a_strange_stop", kPatience, ServiceCaller::Signature::kOfArbiter);
  EXPECT_TRUE(waitFor([&] { return lines.have("a_strange_stop: stopped (answered by /cmd_vel_arbiter)\n"); }));
  EXPECT_EQ(lines.last(), teleop::Severity::kGood);
  EXPECT_EQ(severityOfAnswer(true, "3 of 3 robots stopped; " + unsignedAnswerOf("robot2")), teleop::Severity::kWarning);
}

}  // namespace
}  // namespace frontier_pilot

int main(int argc, char** argv) {
  ::testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "service_caller_test");
  const ros::NodeHandle node;
  return RUN_ALL_TESTS();
}
