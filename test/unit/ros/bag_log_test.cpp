#include "frontier_pilot/ros/bag_log.h"

#include <gtest/gtest.h>
#include <nav_msgs/Odometry.h>
#include <rosbag/bag.h>
#include <sensor_msgs/LaserScan.h>
#include <std_msgs/Bool.h>
#include <tf2_msgs/TFMessage.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "frontier_pilot/core/motion.h"

namespace frontier_pilot {
namespace {

namespace fs = std::filesystem;

geometry_msgs::TransformStamped mount(const std::string& parent, const std::string& child, double x) {
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
    std::string pattern = (fs::temp_directory_path() / "bag_log_XXXXXX").string();
    ASSERT_NE(mkdtemp(pattern.data()), nullptr);
    folder_ = pattern;
    path_ = (folder_ / "drive.bag").string();
    bag_.open(path_, rosbag::bagmode::Write);
  }
  void TearDown() override { fs::remove_all(folder_); }

  void writeOdometry(double seconds) {
    nav_msgs::Odometry msg;
    msg.header.stamp = ros::Time(seconds);
    msg.header.frame_id = "odom";
    msg.pose.pose.position.x = seconds - 100.0;
    msg.pose.pose.orientation.w = 1.0;
    bag_.write("/odom", msg.header.stamp, msg);
  }
  void writeScan(double seconds, const std::string& frame = "base_scan") {
    sensor_msgs::LaserScan msg;
    msg.header.stamp = ros::Time(seconds);
    msg.header.frame_id = frame;
    msg.angle_min = -1.0F;
    msg.angle_max = 1.0F;
    msg.angle_increment = 0.5F;
    msg.range_max = 8.0F;
    msg.ranges.assign(5, 2.0F);
    bag_.write("scan", msg.header.stamp, msg);
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
  ScanLog read(const BagTopics& topics = {}) {
    bag_.close();
    return readBagLog(path_, topics);
  }
  std::string problem(const BagTopics& topics = {}) {
    try {
      read(topics);
    } catch (const LogError& error) {
      return error.what();
    }
    return "none";
  }

  fs::path folder_;
  std::string path_;
  rosbag::Bag bag_;
};

TEST_F(BagLog, PairsScansWithTheOdometryOfTheirStampAndFindsTheScanner) {
  writeDrive(20);
  writeMounts();  // the mount may come late in the file
  const ScanLog log = read();
  ASSERT_EQ(log.records.size(), 20U);
  EXPECT_TRUE(log.notes.empty());
  const LogRecord& record = log.records[7];
  EXPECT_EQ(record.scan.stamp, timeFromSeconds(100.75));
  EXPECT_FALSE(isJump(record.T_odom_base, Pose2(0.75, 0.0, 0.0), 1e-6, 1e-6));
  EXPECT_FALSE(isJump(record.scan.T_base_sensor, Pose2(0.3, 0.0, 0.0), 1e-6, 1e-6));
  EXPECT_EQ(record.scan.ranges.size(), 5U);
}

TEST_F(BagLog, LeavesOutAndCountsWhatCannotBeUsed) {
  writeMounts();
  writeScan(90.0);
  writeDrive(5);
  writeScan(100.3, "elsewhere");
  const ScanLog log = read();
  EXPECT_EQ(log.records.size(), 5U);
  ASSERT_EQ(log.notes.size(), 2U);
  EXPECT_NE((log.notes[0] + log.notes[1]).find("1 x scan without odometry for its stamp"), std::string::npos);
}

TEST_F(BagLog, SaysWhatItDidNotFind) {
  writeDrive(3);
  EXPECT_NE(problem().find("holds no usable scan on 'scan' with odometry on 'odom'; 3 x scan"), std::string::npos)
      << problem();
}

TEST_F(BagLog, ReadsOtherTopicsWhenTold) {
  writeMounts();
  writeDrive(3);
  BagTopics topics;
  topics.scan = "/front/scan";
  EXPECT_NE(problem(topics).find("'/front/scan'"), std::string::npos);
  topics.scan = "/scan";
  EXPECT_EQ(readBagLog(path_, topics).records.size(), 3U);
}

TEST_F(BagLog, SaysThatAFileIsNoBag) {
  bag_.close();
  std::ofstream(path_) << "#ROSBAG V2.0\nand nothing else";
  EXPECT_THROW(readBagLog(path_, {}), LogError);
  EXPECT_THROW(readBagLog(path_ + ".none", {}), LogError);
}

}  // namespace
}  // namespace frontier_pilot
