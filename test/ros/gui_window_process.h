#pragma once

#include <geometry_msgs/Twist.h>
#include <unistd.h>

#include <QApplication>

#include "ros/common/names.h"
#include "ros/gui_window.h"

namespace frontier_pilot::test {

/// Starts the test's own program once more, as a window that drives forward. Gives the process, or -1.
inline pid_t startWindowProcess() {
  const pid_t child = fork();
  if (child != 0) return child;
  execl("/proc/self/exe", "gui_test", "--window", "__name:=window_to_freeze", nullptr);
  _exit(127);
}

/// What that program does: drives forward until it is ended.
inline int driveForward() {
  Window window;
  if (!waitFor([&] { return window.text("driver") == "manual holds the robot still"; })) return 1;
  double commanded = 0.0;
  ros::NodeHandle node;
  const ros::Subscriber manual = node.subscribe<geometry_msgs::Twist>(
      names::kCmdVelManual, 1, [&](const geometry_msgs::Twist::ConstPtr& twist) { commanded = twist->linear.x; });
  const auto goes = [&] {
    ros::spinOnce();
    return commanded > 0.09;
  };
  // On a busy machine the window may take a delay of its own for a freeze and drop what was asked for.
  while (ros::ok() && !QTest::qWaitFor(goes, 500)) window.click("Go");
  return QApplication::exec();
}

}  // namespace frontier_pilot::test
