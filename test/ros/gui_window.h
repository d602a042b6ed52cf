#pragma once

#include <gtest/gtest.h>
#include <ros/ros.h>

#include <QAbstractButton>
#include <QApplication>
#include <QLabel>
#include <QPlainTextEdit>
#include <QtTest>
#include <cstdlib>
#include <functional>

#include "gui/pilot_controller.h"
#include "ros/teleop_gui/gui_bridge.h"

namespace frontier_pilot::test {

/// What a test of the window needs to run: a QApplication without a screen, and a node of that name.
class WindowProgram {
 public:
  WindowProgram(int& argc, char** argv, const char* name) : application_(prepared(argc, argv, name), argv) {}

  /// Runs all tests, with so many threads for the callbacks of the test itself. Returns the exit code.
  static int runTests(unsigned threads = 1) {
    const ros::NodeHandle keeps_ros_alive;
    ros::AsyncSpinner spinner(threads);
    spinner.start();
    return RUN_ALL_TESTS();
  }

 private:
  static int& prepared(int& argc, char** argv, const char* name) {
    setenv("QT_QPA_PLATFORM", "offscreen", 1);
    ::testing::InitGoogleTest(&argc, argv);
    ros::init(argc, argv, name);
    return argc;
  }

  QApplication application_;
};

/// The whole operator's side, as teleop_gui has it, on a screen that is not there.
struct Window {
  explicit Window(const teleop::TeleopParameters& parameters = defaults())
      : bridge(ros::NodeHandle(), parameters, GuiBridge::Manual::kAlways, [] { return ros::ok(); }),
        widget(parameters),
        controller(widget, bridge, fromSeconds(parameters.liveness_timeout)) {
    widget.resize(1200, 800);
    widget.show();
  }

  static const teleop::TeleopParameters& defaults() {
    static const teleop::TeleopParameters parameters;
    return parameters;
  }

  QWidget* find(const char* name) const { return widget.findChild<QWidget*>(name); }
  void click(const char* name) const { QTest::mouseClick(find(name), Qt::LeftButton); }
  bool checked(const char* name) const {
    auto* button = widget.findChild<QAbstractButton*>(name);
    return button != nullptr && button->isChecked();
  }
  QString text(const char* name) const {
    auto* label = widget.findChild<QLabel*>(name);
    return label == nullptr ? QString() : label->text();
  }
  QString log() const { return widget.findChild<QPlainTextEdit*>("log")->toPlainText(); }

  GuiBridge bridge;
  gui::PilotWidget widget;
  gui::PilotController controller;
};

/// Lets the window live until `condition` holds; false after 10 s.
inline bool waitFor(const std::function<bool()>& condition) { return QTest::qWaitFor(condition, 10000); }

/// Clicks Clear until the stop is cleared: the arbiter refuses while somebody asked to move a moment ago.
inline bool clears(const Window& window) {
  return waitFor([&window] {
    window.click("clear_emergency_stop");
    QTest::qWait(200);
    return window.text("driver") == "manual holds the robot still";
  });
}

}  // namespace frontier_pilot::test
