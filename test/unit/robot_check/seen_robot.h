#pragma once

#include "robot_check/observation.h"

namespace frontier_pilot::robot_check {

/// A transform in the plane, `height` [m] up.
inline FrameLink link(const std::string& parent, const std::string& child, const Pose2& pose, double height,
                      const std::string& node, bool is_static) {
  FrameLink made;
  made.parent = parent;
  made.child = child;
  made.T_parent_child.translate(Eigen::Vector3d(pose.x, pose.y, height));
  made.T_parent_child.rotate(Eigen::AngleAxisd(pose.yaw, Eigen::Vector3d::UnitZ()));
  made.is_static = is_static;
  made.stream.count = is_static ? 1 : 150;
  made.stream.rate = is_static ? 0.0 : 50.0;
  made.stream.publishers = {node};
  if (!is_static) made.stream.lag = 0.005;
  return made;
}

/// A robot with other names than ours that could drive, with what was told of it.
struct SeenRobot {
  Expectation expected;
  Observation seen;

  SeenRobot() {
    expected.scan = "/base_scan";
    expected.odom = "/wheels/odom";
    expected.cmd_vel = "/drive";
    expected.robot.base_frame = "base_link";
    seen.seconds = 5.0;
    seen.topics = {{"/base_scan", "sensor_msgs/LaserScan", {"/lidar"}, {}},
                   {"/wheels/odom", "nav_msgs/Odometry", {"/base"}, {}},
                   {"/drive", "geometry_msgs/Twist", {}, {"/base"}}};
    seen.links = {link("odom", "base_link", {1.0, 2.0, 0.3}, 0.0, "/base", false),
                  link("base_link", "laser", {0.05, -0.02, 3.0}, 0.2, "/state_publisher", true)};
    seen.scan.count = 50;
    seen.scan.rate = 10.0;
    seen.scan.publishers = {"/lidar"};
    seen.scan.frames = {"laser"};
    seen.scan.lag = 0.11;  // it is stamped when the sweep begins
    seen.scan.beams = 360;
    seen.scan.angle_increment = 2.0 * kPi / 360.0;
    seen.scan.time_increment = 0.1 / 360.0;
    seen.scan.last = LaserScan2();
    seen.scan.last->angle_min = -kPi;
    seen.scan.last->angle_increment = seen.scan.angle_increment;
    seen.scan.last->range_max = 8.0;
    seen.scan.last->ranges.assign(seen.scan.beams, 2.0F);
    seen.odometry.count = 150;
    seen.odometry.rate = 30.0;
    seen.odometry.publishers = {"/base"};
    seen.odometry.frames = {"odom"};
    seen.odometry.lag = 0.01;
  }

  /// Our own nodes, the arbiter subscribed to all of its inputs, and the operator's window, which shows cmd_vel and
  /// does not drive.
  void addOwnNodes() {
    const std::vector<std::string> window = {"/teleop_gui"};
    topic("/cmd_vel_arbiter/status") = {
        "/cmd_vel_arbiter/status", "frontier_pilot/ArbiterStatus", {"/cmd_vel_arbiter"}, window};
    topic("/drive").publishers = {"/cmd_vel_arbiter"};
    topic("/drive").subscribers.push_back(window.front());
    const auto addSource = [this](const std::string& name, const std::vector<std::string>& nodes) {
      seen.topics.push_back({name, "geometry_msgs/Twist", nodes, {"/cmd_vel_arbiter"}});
    };
    addSource("/cmd_vel_avoid", {"/obstacle_avoider"});
    addSource("/cmd_vel_behavior", {});
    addSource("/cmd_vel_manual", {});
    addSource("/cmd_vel_nav", {"/navigator"});
    addSource("/cmd_vel_patrol", {"/patrol_server"});
    addSource("/joystick/cmd_vel", {});  // a source of the operator's own
  }

  Topic& topic(const std::string& name) {
    for (Topic& topic : seen.topics) {
      if (topic.name == name) return topic;
    }
    seen.topics.push_back({name, "", {}, {}});
    return seen.topics.back();
  }
};

}  // namespace frontier_pilot::robot_check
