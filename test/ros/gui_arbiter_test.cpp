// The operator's window when the arbiter is killed and started anew.

#include <frontier_pilot/ArbiterStatus.h>
#include <gtest/gtest.h>
#include <ros/network.h>
#include <signal.h>
#include <std_msgs/Bool.h>
#include <std_srvs/Trigger.h>

#include <atomic>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>

#include "ros/common/master/xml_rpc.h"
#include "ros/common/names.h"
#include "ros/gui_robot.h"
#include "ros/gui_window.h"

namespace frontier_pilot {
namespace {

using test::clears;
using test::GuiOnTheWire;
using test::waitFor;
using test::Window;

/// The process id of a node, of which the master and the node are asked; 0 if one of them does not answer.
int processOf(const std::string& name) {
  XmlRpc::XmlRpcValue question;
  question[0] = ros::this_node::getName();
  XmlRpc::XmlRpcValue whom = question;
  whom[1] = name;
  auto uri = requestFromMaster("lookupNode", whom);
  std::string host;
  std::uint32_t port = 0;
  if (!uri || !ros::network::splitURI(static_cast<std::string>(*uri), host, port)) return 0;
  auto process = requestFrom(host, port, "getPid", question);
  return process ? static_cast<int>(*process) : 0;
}

// [GUI-1]
TEST_F(GuiOnTheWire, AnArbiterThatWasStartedAnewIsNotDrivenByTheSetPointOfBefore) {
  Window window;
  ASSERT_TRUE(ready(window));
  ASSERT_TRUE(drivesAtGo(window)) << window.log().toStdString();
  const int arbiter = processOf("/cmd_vel_arbiter");
  ASSERT_GT(arbiter, 0);
  kill(arbiter, SIGKILL);
  EXPECT_TRUE(
      waitFor([&] { return window.log().contains("set-point dropped: the arbiter has ended or was started anew"); }));
  EXPECT_EQ(processOf("/cmd_vel_arbiter"), 0) << "the new arbiter might have heard the set-point";
  EXPECT_TRUE(window.widget.setPoint().isZero());
  ASSERT_TRUE(ready(window));
  QTest::qWait(500);  // that nothing comes can only be seen by waiting
  EXPECT_EQ(robot_.command, 0.0);
  EXPECT_LT(std::abs(robot_.speed), 1e-6);
}

// [ARB-8] [GUI-2]
TEST_F(GuiOnTheWire, AStopIsGivenToTheNextArbiterAlthoughTheWindowIsClosedBeforeThatIsThere) {
  std::atomic<bool> stopped{false};
  const ros::Subscriber state = ros::NodeHandle().subscribe<std_msgs::Bool>(
      names::kEmergencyStopState, 1, [&stopped](const std_msgs::Bool::ConstPtr& msg) { stopped = msg->data != 0; });
  {
    Window window;
    ASSERT_TRUE(ready(window));
    const int arbiter = processOf("/cmd_vel_arbiter");
    ASSERT_GT(arbiter, 0);
    kill(arbiter, SIGKILL);
    EXPECT_TRUE(waitFor([&] { return processOf("/cmd_vel_arbiter") == 0; }));
    window.click("emergency_stop");
  }
  EXPECT_TRUE(waitFor([&] { return stopped.load(); }));
  Window next;
  EXPECT_TRUE(clears(next)) << "for the tests that follow";
}

/// A process that is suspended, until this is destroyed.
class Frozen {
 public:
  explicit Frozen(int pid) : pid_(pid) { kill(pid_, SIGSTOP); }
  ~Frozen() { kill(pid_, SIGCONT); }
  Frozen(const Frozen&) = delete;
  Frozen& operator=(const Frozen&) = delete;

 private:
  int pid_;
};

// [GUI-1] [ARB-8] What the window sends meanwhile would be delivered after a stop and its clear.
TEST_F(GuiOnTheWire, AnArbiterThatIsSilentIsSentAZeroAndThenNothing_GUI_1) {
  Window window;
  ASSERT_TRUE(ready(window));
  ASSERT_TRUE(drivesAtGo(window)) << window.log().toStdString();
  {
    const Frozen frozen_arbiter(processOf("/cmd_vel_arbiter"));
    EXPECT_TRUE(waitFor([&] { return window.log().contains("set-point dropped: the arbiter is silent"); }));
    EXPECT_TRUE(waitFor([&] { return robot_.manual_command == 0.0; }));
    const int count = robot_.manual_count;
    QTest::qWait(500);  // that nothing comes can only be seen by waiting
    EXPECT_LE(robot_.manual_count, count + 1);
  }
  ASSERT_TRUE(ready(window));
  EXPECT_TRUE(drivesAtGo(window)) << window.log().toStdString();
}

// [ARB-12] [GUI-2]
TEST_F(GuiOnTheWire, TheStopNeedsNoMasterAndTheWindowSaysSoWhileTheArbiterIsHeard) {
  Window window;
  ASSERT_TRUE(ready(window));
  ASSERT_TRUE(drivesAtGo(window)) << window.log().toStdString();
  const int arbiter = processOf("/cmd_vel_arbiter");
  const std::optional<int> master = pidOfMaster();
  ASSERT_TRUE(arbiter > 0 && master) << arbiter;
  const Frozen frozen_master(*master);
  const auto says = [&] { return window.text("summary").contains("The emergency stop works without it"); };
  EXPECT_TRUE(waitFor(says));
  window.click("emergency_stop");
  const auto* stop = qobject_cast<QAbstractButton*>(window.find("emergency_stop"));
  EXPECT_TRUE(waitFor([&] { return stop->text() == "STOPPED"; })) << window.log().toStdString();
  const Frozen frozen_arbiter(arbiter);
  EXPECT_TRUE(waitFor([&] { return !says(); })) << "a connection alone says nothing";
}

// [ARB-12] [GUI-2] The master leads to whoever has registered the service last.
TEST_F(GuiOnTheWire, TheStopGoesToTheArbiterWhileAnotherNodeOffersItsService) {
  Window window;
  ASSERT_TRUE(clears(window)) << "the stop of the test before";
  ASSERT_TRUE(ready(window));
  std::atomic<int> calls{0};
  std::atomic<bool> contested{false};
  const ros::Subscriber status = ros::NodeHandle().subscribe<ArbiterStatus>(
      names::kArbiterStatus, 1,
      [&contested](const ArbiterStatus::ConstPtr& msg) { contested = msg->state == ArbiterStatus::CONTESTED; });
  const boost::function<bool(std_srvs::Trigger::Request&, std_srvs::Trigger::Response&)> answer =
      [&calls](std_srvs::Trigger::Request&, std_srvs::Trigger::Response& response) {
        ++calls;
        response.message = "fake stop";
        return response.success = 1;
      };
  {
    const ros::ServiceServer stranger = ros::NodeHandle().advertiseService(names::kEmergencyStop, answer);
    ASSERT_TRUE(waitFor([&] { return contested.load(); })) << window.log().toStdString();
    QTest::qWait(300);  // the window hears it, too, and looks at it ten times a second
    window.click("emergency_stop");
    const auto* stop = qobject_cast<QAbstractButton*>(window.find("emergency_stop"));
    EXPECT_TRUE(waitFor([&] { return stop->text() == "STOPPED"; })) << window.log().toStdString();
  }
  EXPECT_EQ(calls, 0);
}

}  // namespace
}  // namespace frontier_pilot

int main(int argc, char** argv) {
  frontier_pilot::test::WindowProgram program(argc, argv, "gui_arbiter_test");
  return program.runTests();
}
