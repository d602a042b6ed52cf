// The services that the operator's window calls: those that come and go, and those that hang. And goals that do not
// arrive.

#include <actionlib_msgs/GoalStatusArray.h>
#include <frontier_pilot/PatrolAction.h>
#include <gtest/gtest.h>
#include <ros/ros.h>
#include <std_srvs/SetBool.h>
#include <unistd.h>

#include <atomic>
#include <cmath>
#include <mutex>
#include <string>
#include <vector>

#include "ros/common/names.h"
#include "ros/gui_robot.h"
#include "ros/gui_window.h"

namespace frontier_pilot {
namespace {

using test::clears;
using test::GuiOnTheWire;
using test::waitFor;
using test::Window;

// [GUI-3]
TEST_F(GuiOnTheWire, ServicesThatComeAndGoAreShown) {
  Window window;
  ASSERT_TRUE(ready(window));
  EXPECT_FALSE(window.find("explore_start")->isEnabled());
  ros::NodeHandle node;
  std::atomic<int> calls{0};
  const test::Switch handle = [&calls](std_srvs::SetBool::Request&, std_srvs::SetBool::Response& response) {
    ++calls;
    return response.success = 1;
  };
  for (int round = 1; round <= 2; ++round) {
    ros::ServiceServer server = node.advertiseService(names::kSetExplorationEnabled, handle);
    ASSERT_TRUE(waitFor([&] { return window.find("explore_start")->isEnabled(); }));
    window.click("explore_start");
    EXPECT_TRUE(waitFor([&] { return calls == round; }));
    server.shutdown();
    EXPECT_TRUE(waitFor([&] { return !window.find("explore_start")->isEnabled(); }));
  }
}

// [FLT-1]
TEST_F(GuiOnTheWire, SourcesThatNoServiceCanBeNamedAfterAreShownAndDoNotEndTheWindow) {
  Window window;
  ASSERT_TRUE(ready(window));
  test::NamelessSources stranger;
  EXPECT_TRUE(waitFor([&] { return stranger.speaks() && window.find("enable_a b") != nullptr; }));
  window.bridge.request({teleop::OperatorRequest::Kind::kEnableSource, true, "a b"});
  QTest::qWait(2500);  // the services are looked for once a second
  EXPECT_TRUE(window.log().contains("'a b' has no switch") &&
              window.log().contains("'set_a b_enabled' is not a valid service name"));
}

// [GUI-3]
TEST_F(GuiOnTheWire, AServiceThatNeverAnswersHoldsNeitherTheWindowNorTheEmergencyStop) {
  Window window;
  ASSERT_TRUE(ready(window));
  std::atomic<bool> hang{true};
  std::atomic<int> calls{0};
  const test::Switch handle = [&hang, &calls](std_srvs::SetBool::Request&, std_srvs::SetBool::Response&) {
    for (++calls; hang;) usleep(10000);
    return true;
  };
  ros::ServiceServer server = ros::NodeHandle().advertiseService(names::kSetExplorationEnabled, handle);
  ASSERT_TRUE(waitFor([&] { return window.find("explore_start")->isEnabled(); }));
  window.click("explore_start");
  EXPECT_TRUE(waitFor([&] { return calls == 1; }));
  for (const char* button : {"explore_start", "explore_start", "Go"}) window.click(button);
  EXPECT_TRUE(waitFor([&] { return robot_.speed > 0.04; })) << "the window still drives";
  window.click("emergency_stop");
  EXPECT_TRUE(waitFor([&] { return window.text("driver") == "Emergency stop"; }));
  EXPECT_TRUE(waitFor([&] { return std::abs(robot_.speed) < 1e-6; }));
  hang = false;
  EXPECT_TRUE(clears(window));
  EXPECT_EQ(calls, 1) << "a call that waits for its answer is not made again";
}

// [GUI-2] [ARB-12]
TEST_F(GuiOnTheWire, AStopOvertakesWhatWaitsBehindAServiceThatHangsAndCanBeCleared_GUI_2) {
  using Kind = teleop::OperatorRequest::Kind;
  Window window;
  ASSERT_TRUE(ready(window));
  std::atomic<bool> hang{true};
  std::atomic<int> pauses{0}, avoider_calls{0};
  const test::Switch pause = [&](std_srvs::SetBool::Request&, std_srvs::SetBool::Response&) {
    for (++pauses; hang;) usleep(10000);
    return true;
  };
  const test::Switch avoid = [&](std_srvs::SetBool::Request&, std_srvs::SetBool::Response&) { return ++avoider_calls; };
  const ros::ServiceServer explorer = ros::NodeHandle().advertiseService(names::kSetExplorationEnabled, pause);
  const ros::ServiceServer avoider = ros::NodeHandle().advertiseService(names::kSetObstacleAvoidEnabled, avoid);
  window.bridge.request({Kind::kExplore, false, {}});
  EXPECT_TRUE(waitFor([&] { return pauses == 1; }));
  window.bridge.request({Kind::kEnableAvoider, true, {}});
  window.click("emergency_stop");
  EXPECT_TRUE(waitFor([&] { return window.text("driver") == "Emergency stop"; }));
  EXPECT_TRUE(clears(window)) << "the arbiter is not called by the one who waits for the explorer";
  hang = false;
  EXPECT_TRUE(waitFor([&] { return window.log().contains("set_obstacle_avoid_enabled on is not done"); }));
  QTest::qWait(500);  // that nothing comes can only be seen by waiting
  EXPECT_EQ(avoider_calls, 0);
}

/// A server of patrols that obeys no goal, and keeps the ids of goals and of cancels.
class FeignedPatrols {
 public:
  using Ids = std::vector<std::string>;

  /// What goes on; with nothing it is as if no goal had arrived. A server is up only as long as it says so.
  void sayStatus(const Ids& active = {}) const {
    actionlib_msgs::GoalStatusArray status;
    for (const std::string& id : active) {
      status.status_list.emplace_back().goal_id.id = id;
      status.status_list.back().status = actionlib_msgs::GoalStatus::ACTIVE;
    }
    status_.publish(status);
  }
  Ids goals() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return goals_;
  }
  Ids cancels() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return cancels_;
  }

 private:
  void keep(Ids& ids, const actionlib_msgs::GoalID& id) {
    const std::lock_guard<std::mutex> lock(mutex_);
    ids.push_back(id.id);
  }
  static std::string topic(const char* name) { return std::string(names::kPatrol) + name; }

  mutable std::mutex mutex_;
  Ids goals_, cancels_;
  ros::NodeHandle node_;
  ros::Publisher status_ = node_.advertise<actionlib_msgs::GoalStatusArray>(topic("/status"), 1);
  ros::Subscriber goal_ = node_.subscribe<PatrolActionGoal>(
      topic("/goal"), 10, [this](const PatrolActionGoal::ConstPtr& msg) { keep(goals_, msg->goal_id); });
  ros::Subscriber cancel_ = node_.subscribe<actionlib_msgs::GoalID>(
      topic("/cancel"), 10, [this](const actionlib_msgs::GoalID::ConstPtr& msg) { keep(cancels_, *msg); });
};

// [GUI-2] Goals and cancels have connections of their own: what is pressed later may arrive earlier.
TEST_F(GuiOnTheWire, AGoalThatHasNotArrivedIsCancelledByItsIdWithAStop_GUI_2) {
  using Kind = teleop::OperatorRequest::Kind;
  FeignedPatrols server;
  Window window;
  ASSERT_TRUE(ready(window));
  ASSERT_TRUE(waitFor([&] {
    server.sayStatus();
    return window.find("patrol(sqr)")->isEnabled();
  }));
  window.bridge.request({Kind::kPatrol, true, {}, 1, 0.5, 1});
  ASSERT_TRUE(waitFor([&] { return !server.goals().empty(); }));
  const std::string id = server.goals().front();
  EXPECT_TRUE(server.cancels().empty());
  window.bridge.request({Kind::kEmergencyStop, true, {}});
  EXPECT_TRUE(waitFor([&] { return !server.cancels().empty(); }));
  EXPECT_TRUE(waitFor([&] { return window.text("driver") == "Emergency stop"; }));
  window.bridge.request({Kind::kStopPatrol, false, {}});
  EXPECT_TRUE(waitFor([&] { return !server.cancels().empty() && server.cancels().back().empty(); }));
  FeignedPatrols::Ids cancels = server.cancels();
  ASSERT_GE(cancels.size(), 3U) << "of the stop and of the patrol alone";
  cancels.pop_back();  // the empty id, which cancels all goals that have arrived
  for (const std::string& cancelled : cancels) EXPECT_EQ(cancelled, id);
  EXPECT_TRUE(clears(window));
}

// [GUI-2] [GUI-3] A server that was killed never tells how its goal has ended.
TEST_F(GuiOnTheWire, AGoalThatDiedWithItsServerIsNeitherShownNorCancelledAsTheWindowsOwn_GUI_3) {
  using Kind = teleop::OperatorRequest::Kind;
  FeignedPatrols server;
  Window window;
  ASSERT_TRUE(ready(window));
  const auto patrol = [&window] { return window.bridge.state().patrol; };
  const auto says = [&server](const FeignedPatrols::Ids& active, const auto& condition) {
    return waitFor([&] {
      server.sayStatus(active);
      return condition();
    });
  };
  ASSERT_TRUE(says({}, [&] { return patrol().server_up; }));
  window.bridge.request({Kind::kPatrol, true, {}, 1, 0.5, 1});
  ASSERT_TRUE(waitFor([&] { return !server.goals().empty(); }));
  ASSERT_TRUE(says({server.goals().front()}, [&] { return patrol().own; }));
  ASSERT_TRUE(says({}, [&] { return !patrol().active; })) << "as one that was started anew";
  ASSERT_TRUE(says({"of another client"}, [&] { return patrol().active; }));
  EXPECT_FALSE(patrol().own);
  window.controller.close();
  window.bridge.request({Kind::kStopPatrol, false, {}});  // whose cancel of all goals comes after those of the end
  EXPECT_TRUE(waitFor([&] { return !server.cancels().empty() && server.cancels().back().empty(); }));
  EXPECT_EQ(server.cancels(), FeignedPatrols::Ids{""});
}

}  // namespace
}  // namespace frontier_pilot

int main(int argc, char** argv) {
  frontier_pilot::test::WindowProgram program(argc, argv, "gui_calls_test");
  return program.runTests(2);
}
