#pragma once

#include <gtest/gtest.h>
#include <nav_msgs/Odometry.h>
#include <rosbag/bag.h>
#include <sensor_msgs/LaserScan.h>
#include <tf2_msgs/TFMessage.h>

#include <filesystem>
#include <string>

#include "ros/map_log/bag_log.h"
#include "support/temporary_folder.h"

namespace frontier_pilot {

inline geometry_msgs::TransformStamped mount(const std::string& parent, const std::string& child, double x) {
  geometry_msgs::TransformStamped msg;
  msg.header.stamp = ros::Time(100.0);
  msg.header.frame_id = parent;
  msg.child_frame_id = child;
  msg.transform.translation.x = x;
  msg.transform.rotation.w = 1.0;
  return msg;
}

/// Writes a bag of a drive along x at 1 m/s: odometry at 10 Hz, scans half way between.
class BagLog : public ::testing::Test {
 protected:
  void SetUp() override {
    path_ = (folder_ / "drive.bag").string();
    bag_.open(path_, rosbag::bagmode::Write);
  }

  void writeOdometry(double seconds, const std::string& base = "") { writeOdometryAt(seconds, seconds - 100.0, base); }
  void writeOdometryAt(double seconds, double x, const std::string& base = "") {
    nav_msgs::Odometry msg;
    msg.header.stamp = ros::Time(seconds);
    msg.header.frame_id = "odom";
    msg.child_frame_id = base;
    msg.pose.pose.position.x = x;
    msg.pose.pose.orientation.w = 1.0;
    bag_.write("/odom", msg.header.stamp, msg);
  }
  void writeScan(double seconds, const std::string& frame = "base_scan", double recorded = 0.0) {
    sensor_msgs::LaserScan msg;
    msg.header.stamp = ros::Time(seconds);
    msg.header.frame_id = frame;
    msg.angle_min = -1.0F;
    msg.angle_max = 1.0F;
    msg.angle_increment = 0.5F;
    msg.range_max = 8.0F;
    msg.ranges.assign(5, 2.0F);
    bag_.write("scan", ros::Time(recorded > 0.0 ? recorded : seconds), msg);
  }
  void writeMounts() {
    tf2_msgs::TFMessage msg;
    msg.transforms = {mount("base_footprint", "base_link", 0.1), mount("base_link", "base_scan", 0.2)};
    bag_.write("/tf_static", ros::Time(100.0), msg);
  }
  void writeDrive(int scans) {
    for (int i = 0; i <= scans; ++i) {
      writeOdometry(100.0 + 0.1 * i);
      if (i < scans) writeScan(100.05 + 0.1 * i);
    }
  }
  logs::ScanLog read(const tools::BagTopics& topics = {}) {
    bag_.close();
    return readBagLog(path_, topics);
  }
  std::string problem(const tools::BagTopics& topics = {}) {
    try {
      read(topics);
    } catch (const logs::LogError& error) {
      return error.what();
    }
    return "none";
  }

  const test::TemporaryFolder temporary;
  const std::filesystem::path folder_ = temporary.path();
  std::string path_;
  rosbag::Bag bag_;
};

}  // namespace frontier_pilot
