// The operator's window on two robots, each with a live arbiter, and on the stop of all.

#include <frontier_pilot/FleetStopStatus.h>
#include <geometry_msgs/Twist.h>
#include <gtest/gtest.h>
#include <ros/ros.h>
#include <std_srvs/SetBool.h>

#include <QApplication>
#include <QPushButton>
#include <QtTest>
#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <string>
#include <vector>

#include "gui/controls.h"
#include "gui/fleet_window.h"
#include "ros/common/master/ros_sessions.h"
#include "ros/common/memory/disk.h"
#include "ros/common/memory/session_memory.h"
#include "ros/gui_window.h"
#include "ros/teleop_gui/fleet_bridge.h"

namespace frontier_pilot {
namespace {

using test::waitFor;

/// The speed that a robot's arbiter commands.
class Wheels {
 public:
  explicit Wheels(const std::string& robot)
      : commands_(node_.subscribe<geometry_msgs::Twist>("/" + robot + "/cmd_vel", 50,
                                                        [this](const auto& msg) { forward = msg->linear.x; })) {}

  std::atomic<double> forward{0.0};

 private:
  ros::NodeHandle node_;
  ros::Subscriber commands_;
};

class FleetOnTheWire : public ::testing::Test {
 protected:
  void SetUp() override {
    window_.resize(1300, 900);
    window_.show();
    ASSERT_TRUE(waitFor([&] { return window_.shown() == "robot1" && driver() == "manual holds the robot still"; }))
        << driver().toStdString();
  }
  QWidget* find(const char* name) { return window_.findChild<QWidget*>(name); }
  void click(const char* name) { QTest::mouseClick(find(name), Qt::LeftButton); }
  QString driver() {
    const auto* label = window_.findChild<QLabel*>("driver");
    return label == nullptr ? QString() : label->text();
  }
  QString said(const char* name) {
    const auto* label = window_.findChild<gui::ElidedLabel*>(name);
    return label == nullptr ? QString() : label->fullText();
  }
  QString answer() { return window_.findChild<QLabel*>("stop_all_answer")->text(); }

  /// The next test finds no stop.
  void TearDown() override {
    for (const char* robot : {"robot1", "robot2"}) {
      std_srvs::SetBool clear;
      EXPECT_TRUE(waitFor([&] {
        return ros::service::call(std::string("/") + robot + "/set_emergency_stop", clear) && clear.response.success;
      }));
    }
  }

  FleetBridge bridge_{ros::NodeHandle(), teleop::TeleopParameters(), [] { return ros::ok(); }};
  gui::FleetWindow window_{bridge_};
  Wheels one_{"robot1"}, two_{"robot2"};
};

// [GUI-1] [GUI-3]
TEST_F(FleetOnTheWire, DrivesTheRobotThatWasChosenAlone) {
  // A window that took long to be drawn takes no click for a moment, as after a freeze.
  EXPECT_TRUE(waitFor([&] {
    if (one_.forward == 0.0) click("Go");
    return one_.forward > 0.04;
  }));
  click("robot_robot2");
  EXPECT_TRUE(waitFor([&] {
    return one_.forward == 0.0 && window_.shown() == "robot2" && driver() == "manual holds the robot still";
  }));
  for (int i = 0; i < 4; ++i) click("Go");
  EXPECT_TRUE(waitFor([&] { return two_.forward > 0.0; }));
  QTest::qWait(500);
  EXPECT_NEAR(two_.forward, 0.1, 1e-6) << "its own limit, though four steps are 0.2 m/s";
  EXPECT_EQ(one_.forward, 0.0);
  EXPECT_TRUE(waitFor([&] { return said("robot_state_robot2") == "manual drives"; }));
  click("Stop");
  EXPECT_TRUE(waitFor([&] { return two_.forward == 0.0; }));
}

/// Whether this process listens to `topic`.
bool listensTo(const std::string& topic) {
  std::vector<std::string> topics;
  ros::this_node::getSubscribedTopics(topics);
  return std::find(topics.begin(), topics.end(), topic) != topics.end();
}

// [GUI-3] [MUL-1]
TEST_F(FleetOnTheWire, ListensToTheMapThatTheRobotWhichWasChosenPlansOn) {
  EXPECT_TRUE(waitFor([] { return listensTo("/robot1/map_changes"); }));
  click("robot_robot2");
  EXPECT_TRUE(waitFor([] { return listensTo("/robot2/merged_map_changes"); }));
  // The links to what was shown before, to the first window's own topics too, live on for twelve seconds
  // (FleetBridge::retire).
  constexpr int kRetired = 30'000;  // [ms]
  EXPECT_TRUE(
      QTest::qWaitFor([] { return !listensTo("/map_changes") && !listensTo("/robot1/map_changes"); }, kRetired));
}

// [GUI-1] [MUL-4]
TEST_F(FleetOnTheWire, StopsTheRobotThatWasChosenAMomentAgoAsWell) {
  click("robot_robot2");
  click("emergency_stop");
  for (const char* robot : {"robot_state_robot1", "robot_state_robot2"})
    EXPECT_TRUE(waitFor([&] { return said(robot).startsWith("emergency stop: "); })) << said(robot).toStdString();
  EXPECT_TRUE(waitFor([&] { return window_.shown() == "robot2" && driver().contains("stop", Qt::CaseInsensitive); }))
      << driver().toStdString();
}

// [GUI-2] [MUL-4]
TEST_F(FleetOnTheWire, StopsAllRobotsAndShowsThatTheyAreStopped) {
  click("Go");
  EXPECT_TRUE(waitFor([&] { return one_.forward > 0.04; }));
  click("stop_all");
  EXPECT_TRUE(waitFor([&] { return answer().contains("2 of 2 robots stopped"); })) << answer().toStdString();
  EXPECT_TRUE(waitFor([&] { return one_.forward == 0.0; }));
  for (const char* robot : {"robot_state_robot1", "robot_state_robot2"})
    EXPECT_TRUE(waitFor([&] { return said(robot).startsWith("emergency stop: "); })) << said(robot).toStdString();
}

/// A window of a fleet whose robots the test lists, each by its name: none of them is there.
class FleetOfNames : public ::testing::Test {
 protected:
  void list(const std::vector<std::string>& robots) {
    FleetStopStatus status;
    for (const std::string& robot : robots) status.reached.push_back("/" + robot + "/emergency_stop");
    list_.publish(status);
  }

  ros::NodeHandle node_{"names"};
  ros::Publisher list_ = node_.advertise<FleetStopStatus>("fleet/stop_status", 1, true);
  FleetBridge bridge_{node_, teleop::TeleopParameters(), [] { return ros::ok(); }};
};

// [MUL-4] [FLT-1]
TEST_F(FleetOfNames, WatchesANewRobotHoweverManyThereWereBefore) {
  std::vector<std::string> robots;
  for (int i = 0; i < 50; ++i) robots.push_back("visitor" + std::to_string(i));
  list(robots);
  EXPECT_TRUE(waitFor([] { return listensTo("/visitor49/cmd_vel_arbiter/status"); }));
  list({"visitor7"});
  EXPECT_TRUE(waitFor([&] { return bridge_.fleet().robots.size() == 1; }));
  EXPECT_TRUE(listensTo("/visitor0/cmd_vel_arbiter/status")) << "it may come back";
  list({"visitor7", "another"});
  EXPECT_TRUE(waitFor([] { return listensTo("/another/cmd_vel_arbiter/status"); }));
  EXPECT_TRUE(listensTo("/visitor7/cmd_vel_arbiter/status"));
  EXPECT_FALSE(listensTo("/visitor0/cmd_vel_arbiter/status"));
  EXPECT_TRUE(waitFor([&] { return bridge_.fleet().robots.size() == 2; }));
  for (const auto& robot : bridge_.fleet().robots)
    EXPECT_EQ(robot.text.find("not watched"), std::string::npos) << robot.name;
}

// [FLT-2]
TEST_F(FleetOfNames, KeepsTheParametersOfItsProcessWhenTheViewOfARobotIsClosed) {
  constexpr auto kKind = SessionMemory::Owner::kLastingNode;
  const SessionMemory memory({}, rosSessions(), "parameters", ros::this_node::getName(), kKind, spareFolder());
  const auto kept = [&] { return memory.recall().value_or("nothing"); };
  const std::string before = kept();
  EXPECT_NE(before.find("gui_fleet"), std::string::npos) << before;
  bridge_.openOwn().link.reset();
  EXPECT_EQ(kept(), before);
}

}  // namespace
}  // namespace frontier_pilot

int main(int argc, char** argv) {
  frontier_pilot::test::WindowProgram program(argc, argv, "gui_fleet_test");
  return program.runTests();
}
