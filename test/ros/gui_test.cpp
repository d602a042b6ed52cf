// The operator's window against a live arbiter and a simulated robot. Called with `--window` it is the window alone,
// driving forward: the process that the test of the frozen window freezes.

#include <actionlib/server/simple_action_server.h>
#include <frontier_pilot/PatrolAction.h>
#include <gtest/gtest.h>
#include <ros/poll_manager.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <QApplication>
#include <QRegularExpression>
#include <QSpinBox>
#include <atomic>
#include <cmath>
#include <cstring>

#include "frontier_pilot/core/geometry.h"
#include "ros/common/clock.h"
#include "ros/common/names.h"
#include "ros/gui_robot.h"
#include "ros/gui_window.h"
#include "ros/gui_window_process.h"

namespace frontier_pilot {
namespace {

using test::GuiOnTheWire;
using test::startWindowProcess;
using test::waitFor;
using test::Window;

// [GUI-1]
TEST_F(GuiOnTheWire, ButtonsMoveTheRobotThroughTheArbiterAtTenHertz) {
  Window window;
  ASSERT_TRUE(ready(window));
  EXPECT_TRUE(drivesAtGo(window, 2)) << window.log().toStdString();
  EXPECT_NEAR(robot_.command, 0.10, 1e-9);
  const SteadyTime start = steadyNow();
  const int before = robot_.manual_count;
  EXPECT_TRUE(waitFor([&] { return robot_.manual_count >= before + 40; }));
  EXPECT_NEAR(40.0 / toSeconds(steadyNow() - start), 10.0, 1.0);
  window.click("Stop");
  EXPECT_TRUE(waitFor([&] { return robot_.command == 0.0 && std::abs(robot_.speed) < 1e-6; }));
}

// [GUI-1] The panel in rviz is silent until somebody drives with it.
TEST_F(GuiOnTheWire, TheFirstCommandOfAPanelMovesTheRobot) {
  GuiBridge bridge(ros::NodeHandle(), teleop::TeleopParameters(), GuiBridge::Manual::kOnDemand, [] { return true; });
  ASSERT_TRUE(waitFor([&] {
    bridge.beat({});
    return bridge.state().connected && bridge.state().arbiter.has_value();
  }));
  const int before = robot_.manual_count;
  for (int beat = 0; beat < 20; ++beat) {
    bridge.beat({});
    ros::WallDuration(0.05).sleep();
  }
  EXPECT_EQ(robot_.manual_count, before);
  EXPECT_TRUE(waitFor([&] {
    bridge.beat({0.1, 0.0});
    return robot_.command == 0.1;
  }));
}

// [GUI-2]
TEST_F(GuiOnTheWire, TheEmergencyStopLatchesIsShownAndIsClearedWithoutMotion) {
  Window window;
  ASSERT_TRUE(ready(window));
  EXPECT_TRUE(drivesAtGo(window)) << window.log().toStdString();
  window.click("emergency_stop");
  EXPECT_TRUE(waitFor([&] { return window.text("driver") == "Emergency stop"; }));
  EXPECT_TRUE(waitFor([&] { return robot_.command == 0.0 && std::abs(robot_.speed) < 1e-6; }));
  test::RestlessSource nav;
  int asked = 0;
  EXPECT_TRUE(waitFor([&] { return (asked += nav.asks() ? 1 : 0) > 30; })) << "it asks before Clear is clicked";
  EXPECT_TRUE(waitFor([&] {
    window.click("clear_emergency_stop");
    return nav.asks() && window.text("clear_refusal").startsWith("Not cleared: nav asked to move ");
  }));
  EXPECT_TRUE(window.find("halt_and_clear")->isVisible());
  window.click("halt_and_clear");
  EXPECT_TRUE(waitFor([&] { return window.text("driver") == "manual holds the robot still"; })) << "nav has ended";
  EXPECT_EQ(robot_.command, 0.0);
  EXPECT_TRUE(window.widget.setPoint().isZero());
}

// [GUI-2]
TEST_F(GuiOnTheWire, SwitchingManualOffSilencesItAndLocksThePad) {
  Window window;
  ASSERT_TRUE(ready(window));
  EXPECT_TRUE(drivesAtGo(window)) << window.log().toStdString();
  window.click("enable_manual");
  EXPECT_TRUE(waitFor([&] { return !window.checked("enable_manual"); }));
  EXPECT_FALSE(window.find("Go")->isEnabled());
  EXPECT_TRUE(waitFor([&] { return robot_.manual_command == 0.0 && std::abs(robot_.speed) < 1e-6; }));
  const int count = robot_.manual_count;
  QTest::qWait(500);  // that nothing comes can only be seen by waiting
  EXPECT_LE(robot_.manual_count, count + 1);
  window.click("enable_manual");
  EXPECT_TRUE(waitFor([&] { return window.checked("enable_manual") && window.find("Go")->isEnabled(); }));
}

// [GUI-3]
TEST_F(GuiOnTheWire, AWindowWhoseThreadIsStuckStopsTheRobotWithinASecond) {
  Window window;
  ASSERT_TRUE(ready(window));
  ASSERT_TRUE(drivesAtGo(window)) << window.log().toStdString();
  const SteadyTime frozen = steadyNow();
  while (robot_.speed > 1e-6 && steadyNow() - frozen < std::chrono::seconds(3)) usleep(1000);  // no event is handled
  RecordProperty("stuck_to_standstill_ms", static_cast<int>(1000.0 * toSeconds(steadyNow() - frozen)));
  EXPECT_LT(toSeconds(steadyNow() - frozen), 1.0);
  EXPECT_EQ(robot_.command, 0.0);
  QTest::qWait(500);
  EXPECT_TRUE(window.widget.setPoint().isZero()) << "it must not go on when the window thaws";
  EXPECT_EQ(robot_.command, 0.0);
}

// [GUI-3]
TEST_F(GuiOnTheWire, AProcessThatIsStoppedStopsTheRobotWithinASecond) {
  const pid_t child = startWindowProcess();
  ASSERT_GT(child, 0);
  EXPECT_TRUE(waitFor([&] { return robot_.speed > 0.09; }));
  kill(child, SIGSTOP);
  const SteadyTime frozen = steadyNow();
  EXPECT_TRUE(waitFor([&] { return std::abs(robot_.speed) < 1e-6; }));
  const double seconds = toSeconds(steadyNow() - frozen);
  RecordProperty("sigstop_to_standstill_ms", static_cast<int>(1000.0 * seconds));
  EXPECT_LT(seconds, 1.0);
  EXPECT_TRUE(waitFor([&] { return robot_.command == 0.0; }));
  kill(child, SIGCONT);
  const int count = robot_.manual_count;
  EXPECT_TRUE(waitFor([&] { return robot_.manual_count > count + 10; }));
  EXPECT_EQ(robot_.manual_command, 0.0);
  EXPECT_EQ(robot_.command, 0.0) << "it must not go on when the window thaws";
  kill(child, SIGKILL);
  waitpid(child, nullptr, 0);
}

// [GUI-2] [EXP-10]
TEST_F(GuiOnTheWire, BoundsPosesToInspectAndTheReturnToTheStartAreShownAndChanged) {
  Window window;
  ASSERT_TRUE(ready(window));
  test::BoundedExplorer explorer;
  EXPECT_TRUE(waitFor([&] { return explorer.speaks() && window.text("explorer_bounds") == "within 6.0 m²"; }));
  EXPECT_TRUE(window.text("explorer_end").startsWith("when 9 m2"));
  for (const char* control : {"return_to_start", "clear_bounds", "clear_inspections"})
    ASSERT_TRUE(waitFor([&] { return explorer.speaks() && window.find(control)->isEnabled(); })) << control;
  for (const char* control : {"return_to_start", "clear_bounds", "clear_inspections"}) window.click(control);
  EXPECT_TRUE(waitFor([&] { return explorer.speaks() && window.checked("return_to_start"); }));
  EXPECT_TRUE(waitFor([&] { return explorer.speaks() && window.text("explorer_bounds") == "none"; }));
  EXPECT_TRUE(waitFor([&] { return explorer.speaks() && window.text("explorer_inspect") == "nothing"; }));
}

// [GUI-1] [GUI-3]
TEST_F(GuiOnTheWire, PatrolsAreStartedShownStoppedAndCancelledOnClosing) {
  auto window = std::make_unique<Window>();
  ASSERT_TRUE(ready(*window));
  EXPECT_FALSE(window->find("patrol(sqr)")->isEnabled());
  actionlib::SimpleActionServer<PatrolAction> server(names::kPatrol, false);
  std::atomic<int> goals{0}, cancels{0}, shape{0};
  server.registerGoalCallback([&] {
    shape = static_cast<int>(server.acceptNewGoal()->goal.x);
    PatrolFeedback feedback;
    feedback.state = "line 1";
    server.publishFeedback(feedback);
    ++goals;
  });
  server.registerPreemptCallback([&] {
    PatrolResult result;
    result.result = "patrol canceled";
    server.setPreempted(result);
    ++cancels;
  });
  server.start();
  ASSERT_TRUE(waitFor([&] { return window->find("patrol(sqr)")->isEnabled(); }));
  window->click("patrol(tri)");
  EXPECT_TRUE(waitFor([&] { return window->text("patrol_progress") == "line 1"; }));
  EXPECT_EQ(shape, 2);
  window->click("patrol stop");
  EXPECT_TRUE(waitFor([&] { return window->text("patrol_progress") == "patrol canceled"; }));
  window->click("patrol(sqr)");
  EXPECT_TRUE(waitFor([&] { return goals == 2 && cancels == 1; }));
  window->controller.close();
  EXPECT_TRUE(waitFor([&] { return cancels == 2; })) << "closing cancels what the window has started";
}

// [GUI-2] [GUI-3] [SPN-5]
TEST_F(GuiOnTheWire, TurnsInPlaceAreMadeShownStoppedAndCancelledOnClosing) {
  auto window = std::make_unique<Window>();
  ASSERT_TRUE(ready(*window));
  ASSERT_TRUE(waitFor([&] { return window->find("spin")->isEnabled(); }));
  auto* angle = window->widget.findChild<QSpinBox*>("spin_angle");
  const double before = robot_.yaw;
  angle->setValue(-60);
  window->click("spin");
  EXPECT_TRUE(waitFor([&] { return window->text("driver") == "behavior drives"; }));
  EXPECT_TRUE(waitFor([&] { return window->text("driver") != "behavior drives" && robot_.stands(); }));
  EXPECT_NEAR(angleDifference(robot_.yaw, before), -kPi / 3.0, 0.05);
  // What it was to the degree is the behaviour's affair: 0.05 rad are allowed.
  const QRegularExpressionMatch told = QRegularExpression("^turned (-\\d+)°$").match(window->text("spin_progress"));
  EXPECT_NEAR(told.captured(1).toDouble(), -60.0, 3.0) << window->text("spin_progress").toStdString();

  angle->setValue(360);
  window->click("spin");
  EXPECT_TRUE(waitFor([&] { return robot_.turns() && window->text("spin_progress").startsWith("turned "); }));
  window->click("spin stop");
  EXPECT_TRUE(waitFor([&] { return window->text("spin_progress").contains("canceled") && robot_.stands(); }));

  window->click("spin");
  EXPECT_TRUE(waitFor([&] { return robot_.turns(); }));
  window->controller.close();
  EXPECT_TRUE(waitFor([&] { return robot_.stands(); })) << "closing cancels what the window has started";
  EXPECT_LT(std::abs(angleDifference(robot_.yaw, before)), kPi) << "not because the turn was over";
}

// [GUI-4]
TEST_F(GuiOnTheWire, HeldToRunTheRobotMovesFromPressToRelease) {
  Window window;
  ASSERT_TRUE(ready(window));
  window.widget.findChild<QAbstractButton*>("hold_to_run")->click();
  QTest::mousePress(window.find("Left"), Qt::LeftButton);
  EXPECT_TRUE(waitFor([&] { return robot_.turn_rate > 0.1; }));
  QTest::mouseRelease(window.find("Left"), Qt::LeftButton);
  EXPECT_TRUE(waitFor([&] { return robot_.stands(); }));
  QTest::keyPress(&window.widget, Qt::Key_D);
  EXPECT_TRUE(waitFor([&] { return robot_.turn_rate < -0.1; }));
  window.widget.hide();
  EXPECT_TRUE(waitFor([&] { return robot_.stands(); }));
}

// [GUI-3]
TEST_F(GuiOnTheWire, ClosingSendsZeroAsTheLastWord) {
  Window window;
  ASSERT_TRUE(ready(window));
  ASSERT_TRUE(drivesAtGo(window)) << window.log().toStdString();
  window.controller.close();
  EXPECT_TRUE(waitFor([&] { return robot_.manual_command == 0.0 && robot_.command == 0.0; }));
  const int count = robot_.manual_count;
  QTest::qWait(500);  // that nothing comes can only be seen by waiting
  EXPECT_EQ(robot_.manual_count, count);
}

// [GUI-3] A publisher that is destroyed drops what roscpp has not sent yet; the arbiter would wait a second for more.
TEST_F(GuiOnTheWire, ClosingSendsZeroAlsoOnABusyMachine_GUI_3) {
  auto window = std::make_unique<Window>();
  ASSERT_TRUE(ready(*window));
  ASSERT_TRUE(drivesAtGo(*window)) << window->log().toStdString();
  robot_.manual_held = false;
  const SteadyTime idle = steadyNow() + std::chrono::milliseconds(300);
  const auto busy = ros::PollManager::instance()->addPollThreadListener([idle] {
    while (steadyNow() < idle) usleep(1000);
  });
  window.reset();
  EXPECT_TRUE(waitFor([&] { return robot_.command == 0.0; }));
  EXPECT_TRUE(waitFor([&] { return robot_.manual_held.load(); }))
      << "by the arbiter's timeout, not by the window's zero";
  ros::PollManager::instance()->removePollThreadListener(busy);
}

}  // namespace
}  // namespace frontier_pilot

int main(int argc, char** argv) {
  frontier_pilot::test::WindowProgram program(argc, argv, "gui_test");
  if (argc > 1 && std::strcmp(argv[1], "--window") == 0) return frontier_pilot::test::driveForward();
  return program.runTests(2);
}
