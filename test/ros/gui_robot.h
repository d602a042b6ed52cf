#pragma once

#include <frontier_pilot/ArbiterStatus.h>
#include <frontier_pilot/ExplorerStatus.h>
#include <geometry_msgs/Twist.h>
#include <gtest/gtest.h>
#include <nav_msgs/Odometry.h>
#include <ros/ros.h>
#include <std_srvs/Empty.h>
#include <std_srvs/SetBool.h>
#include <std_srvs/Trigger.h>

#include <atomic>
#include <cmath>
#include <mutex>
#include <utility>

#include "ros/common/names.h"
#include "ros/gui_window.h"

namespace frontier_pilot::test {

/// What goes to the base and what the base does, kept by a thread of its own.
class Robot {
 public:
  Robot() {
    commands_ = node_.subscribe<geometry_msgs::Twist>(names::kCmdVel, 50, [this](const auto& msg) {
      command = msg->linear.x;
      ++command_count;
    });
    manual_ = node_.subscribe<geometry_msgs::Twist>(names::kCmdVelManual, 50, [this](const auto& msg) {
      manual_command = msg->linear.x;
      ++manual_count;
    });
    status_ = node_.subscribe<ArbiterStatus>(names::kArbiterStatus, 50, [this](const auto& msg) {
      if (msg->active_source == "manual" && msg->command.linear.x == 0.0 && msg->command.angular.z == 0.0)
        manual_held = true;
    });
    odometry_ = node_.subscribe<nav_msgs::Odometry>(names::kOdom, 50, [this](const auto& msg) {
      speed = msg->twist.twist.linear.x;
      turn_rate = msg->twist.twist.angular.z;
      yaw = 2.0 * std::atan2(msg->pose.pose.orientation.z, msg->pose.pose.orientation.w);
    });
  }
  bool turns() const { return std::abs(turn_rate) > 0.3; }
  bool stands() const { return std::abs(turn_rate) < 1e-6 && std::abs(speed) < 1e-6; }

  std::atomic<double> command{0.0}, speed{0.0}, turn_rate{0.0}, yaw{0.0}, manual_command{0.0};
  std::atomic<int> command_count{0}, manual_count{0};
  std::atomic<bool> manual_held{false};  ///< whether the arbiter has forwarded a zero of the window's

 private:
  ros::NodeHandle node_;
  ros::Subscriber commands_, manual_, status_, odometry_;
};

/// What answers the calls of a switch.
using Switch = boost::function<bool(std_srvs::SetBool::Request&, std_srvs::SetBool::Response&)>;

/// A source that asks to move whenever it is asked to.
class RestlessSource {
 public:
  RestlessSource() : publisher_(ros::NodeHandle().advertise<geometry_msgs::Twist>(names::kCmdVelNav, 1)) {}
  /// Whether anybody hears it.
  bool asks() {
    geometry_msgs::Twist msg;
    msg.linear.x = 0.1;
    publisher_.publish(msg);
    return publisher_.getNumSubscribers() > 0;
  }

 private:
  ros::Publisher publisher_;
};

/// Somebody who says that there are sources whose names no service can have.
class NamelessSources {
 public:
  NamelessSources() : publisher_(ros::NodeHandle().advertise<ArbiterStatus>(names::kArbiterStatus, 1)) {}
  bool speaks() {
    ArbiterStatus status;
    for (const char* name : {"a b", "\n", "joy-stick", "", "~", "joy"}) status.sources.emplace_back().name = name;
    publisher_.publish(status);
    return true;
  }

 private:
  ros::Publisher publisher_;
};

/// An explorer with bounds that can be cleared and a return to the start that can be switched.
class BoundedExplorer {
 public:
  BoundedExplorer() {
    publisher_ = node_.advertise<ExplorerStatus>(names::kExplorerStatus, 1);
    for (const auto& [x, y] :
         {std::pair(0.0F, 0.0F), std::pair(3.0F, 0.0F), std::pair(3.0F, 2.0F), std::pair(0.0F, 2.0F)}) {
      geometry_msgs::Point32& corner = status_.stay_within.points.emplace_back();
      corner.x = x;
      corner.y = y;
    }
    status_.until = "9 m2 are known";
    status_.to_inspect.resize(2);
    clear_ = node_.advertiseService(names::kClearExplorationBounds, &BoundedExplorer::clear, this);
    inspections_ = node_.advertiseService(names::kClearInspections, &BoundedExplorer::clearInspections, this);
    return_ = node_.advertiseService(names::kSetReturnToStart, &BoundedExplorer::setReturn, this);
  }
  bool speaks() {
    const std::lock_guard<std::mutex> lock(mutex_);
    publisher_.publish(status_);
    return true;
  }

 private:
  bool clear(std_srvs::Trigger::Request&, std_srvs::Trigger::Response& response) {
    const std::lock_guard<std::mutex> lock(mutex_);
    status_.stay_within.points.clear();
    response.success = 1;
    return true;
  }
  bool clearInspections(std_srvs::Trigger::Request&, std_srvs::Trigger::Response& response) {
    const std::lock_guard<std::mutex> lock(mutex_);
    status_.to_inspect.clear();
    response.success = 1;
    return true;
  }
  bool setReturn(std_srvs::SetBool::Request& request, std_srvs::SetBool::Response& response) {
    const std::lock_guard<std::mutex> lock(mutex_);
    status_.return_to_start = request.data;
    response.success = 1;
    return true;
  }

  std::mutex mutex_;
  ExplorerStatus status_;
  ros::NodeHandle node_;
  ros::Publisher publisher_;
  ros::ServiceServer clear_, inspections_, return_;
};

class GuiOnTheWire : public ::testing::Test {
 protected:
  /// Each test begins where the robot has room: how far those before it have driven depends on the machine.
  void SetUp() override {
    std_srvs::Empty call;
    ASSERT_TRUE(ros::service::waitForService(names::kResetPositions, 30000));
    ASSERT_TRUE(ros::service::call(names::kResetPositions, call));
  }

  /// The arbiter is heard, the switches are up, nothing is latched.
  static bool ready(const Window& window) {
    return waitFor([&] {
      return window.find("enable_manual") != nullptr && window.find("enable_manual")->isEnabled() &&
             window.text("driver") == "manual holds the robot still";
    });
  }

  /// Whether the robot drives by so many steps after as many clicks on Go. They are given again while there is no
  /// set-point: a window that was held up, as on a busy machine, drops it, and ignores clicks.
  bool drivesAtGo(const Window& window, int clicks = 1) {
    return waitFor([&] {
      if (window.widget.setPoint().isZero()) {
        for (int i = 0; i < clicks; ++i) window.click("Go");
      }
      return std::abs(robot_.speed - 0.05 * clicks) < 0.01;
    });
  }

  Robot robot_;
};

}  // namespace frontier_pilot::test
