#include "teleop/fleet_view.h"

#include <gtest/gtest.h>

namespace frontier_pilot::teleop {
namespace {

RobotReports standing() {
  RobotReports reports;
  reports.arbiter = ArbiterView();
  reports.arbiter->severity = Severity::kGood;
  return reports;
}

ExplorerView exploring() {
  ExplorerView explorer;
  explorer.running = true;
  explorer.severity = Severity::kActive;
  explorer.reason_text = "goal sent";
  explorer.share_explored = 0.634;
  return explorer;
}

NavigationView underWay(Severity severity, const std::string& status) {
  NavigationView navigation;
  navigation.has_goal = true;
  navigation.severity = severity;
  navigation.status = status;
  return navigation;
}

void expect(const RobotReports& reports, Severity severity, const std::string& text, bool reached = true) {
  const RobotView view = atAGlance("robot1", reports, reached);
  EXPECT_EQ(view.name, "robot1");
  EXPECT_EQ(view.severity, severity) << view.text;
  EXPECT_EQ(view.text, text);
}

// [GUI-2] [MUL-4]
TEST(FleetView, SaysWhatEachRobotDoes_GUI_2) {
  RobotReports reports = standing();
  expect(reports, Severity::kIdle, "stands");
  reports.navigation = underWay(Severity::kActive, "following the path");
  expect(reports, Severity::kActive, "drives to its goal: following the path");
  reports.explorer = exploring();
  expect(reports, Severity::kActive, "explores, 63 % seen: goal sent");
  reports = standing();
  reports.arbiter->active_source = "manual";
  expect(reports, Severity::kIdle, "stands");
  reports.arbiter->command = {0.1, 0.0};
  expect(reports, Severity::kActive, "manual drives");
}

// [GUI-2] [MUL-3]
TEST(FleetView, SaysWhyARobotStands_GUI_2) {
  RobotReports reports = standing();
  reports.explorer = exploring();
  reports.navigation = underWay(Severity::kWarning, "waiting: waits for robot2");
  expect(reports, Severity::kWarning, "waiting: waits for robot2, 63 % seen");
  reports.navigation.reset();
  reports.explorer->running = false;
  reports.explorer->severity = Severity::kGood;
  reports.explorer->reason_text = "no reachable frontier left";
  expect(reports, Severity::kGood, "stands: no reachable frontier left");
  reports.arbiter->problems = {"nav: bad values"};
  expect(reports, Severity::kWarning, "nav: bad values");
  reports.arbiter->stop_cause = "emergency_stop called by /rqt";
  expect(reports, Severity::kError, "emergency stop: emergency_stop called by /rqt");
}

// [GUI-2] [MUL-4] nothing that is old is shown as if it were new
TEST(FleetView, SaysThatARobotIsSilentOrOutOfReach_GUI_2) {
  expect({}, Severity::kIdle, "nothing heard yet");
  expect({}, Severity::kError, "nothing heard yet", false);
  RobotReports reports = standing();
  expect(reports, Severity::kError, "a stop of all robots does not reach it", false);
  reports.explorer = exploring();
  reports.explorer->status_age = kStatusLifetime + 0.1;
  expect(reports, Severity::kIdle, "stands");
  reports.navigation = underWay(Severity::kActive, "following the path");
  reports.navigation->status_age = kStatusLifetime + 0.1;
  expect(reports, Severity::kIdle, "stands");
  reports.arbiter->status_age = 12.0;
  expect(reports, Severity::kError, "silent for 12 s");
}

}  // namespace
}  // namespace frontier_pilot::teleop
