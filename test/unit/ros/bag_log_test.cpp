#include "ros/map_log/bag_log.h"

#include <gtest/gtest.h>
#include <rosbag/bag.h>
#include <std_msgs/Bool.h>
#include <tf2_msgs/TFMessage.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>

#include "frontier_pilot/core/motion.h"
#include "written_bag.h"

namespace frontier_pilot {
namespace {

namespace fs = std::filesystem;

bool holds(const std::vector<std::string>& notes, const std::string& wanted) {
  return std::find(notes.begin(), notes.end(), wanted) != notes.end();
}

TEST_F(BagLog, PairsScansWithTheOdometryOfTheirStampAndFindsTheScanner) {
  writeDrive(20);
  writeMounts();  // the mount may come late in the file
  const logs::ScanLog log = read();
  ASSERT_EQ(log.records.size(), 20U);
  EXPECT_TRUE(log.notes.empty());
  const logs::LogRecord& record = log.records[7];
  EXPECT_EQ(record.scan.stamp, timeFromSeconds(100.75));
  EXPECT_FALSE(isJump(record.T_odom_base, Pose2(0.75, 0.0, 0.0), 1e-6, 1e-6));
  EXPECT_FALSE(isJump(record.scan.T_base_sensor, Pose2(0.3, 0.0, 0.0), 1e-6, 1e-6));
  EXPECT_EQ(record.scan.ranges.size(), 5U);
}

// [FLT-1] the difference between such a stamp and the time of recording is no ros::Duration
TEST_F(BagLog, IsReadInSpiteOfAStampAtTheEndOfTime_FLT_1) {
  writeMounts();
  writeDrive(20);
  writeScan(3.9e9, "base_scan", 100.3);
  tf2_msgs::TFMessage msg;
  msg.transforms = {mount("odom", "base_footprint", 0.3), mount("base_footprint", "base_scan", 0.3)};
  for (auto& transform : msg.transforms) transform.header.stamp = ros::TIME_MAX;
  bag_.write("/tf", ros::Time(100.3), msg);
  const logs::ScanLog log = read();
  EXPECT_EQ(log.records.size(), 20U);
  EXPECT_TRUE(holds(log.notes, "2 x transform whose stamp is out of range"));
}

// [ROB-2] as bags from the time before tf2 have them
TEST_F(BagLog, TakesFramesWithALeadingSlash_ROB_2) {
  tf2_msgs::TFMessage msg;
  msg.transforms = {mount("/base_footprint", "/base_scan", 0.3)};
  bag_.write("/tf_static", ros::Time(100.0), msg);
  for (int i = 0; i <= 5; ++i) writeOdometry(100.0 + 0.1 * i);
  for (int i = 0; i < 5; ++i) writeScan(100.05 + 0.1 * i, "/base_scan");
  const logs::ScanLog log = read();
  ASSERT_EQ(log.records.size(), 5U);
  EXPECT_FALSE(isJump(log.records[0].scan.T_base_sensor, Pose2(0.3, 0.0, 0.0), 1e-6, 1e-6));
}

// [ROB-2]
TEST_F(BagLog, TakesTheFrameOfTheBaseFromOdometryThatBeginsAfterTheFirstScan_ROB_2) {
  tf2_msgs::TFMessage msg;
  msg.transforms = {mount("base_link", "base_scan", 0.2)};
  bag_.write("/tf_static", ros::Time(99.0), msg);
  writeScan(100.05, "base_scan", 99.9);
  for (int i = 0; i <= 5; ++i) writeOdometry(100.0 + 0.1 * i, "base_link");
  for (int i = 1; i < 5; ++i) writeScan(100.05 + 0.1 * i);
  const logs::ScanLog log = read();
  EXPECT_EQ(log.records.size(), 5U);
  EXPECT_EQ(log.notes, std::vector<std::string>{});
}

TEST_F(BagLog, SaysThatTheFrameThatWasAskedForIsNotInTheBag) {
  writeMounts();
  writeOdometry(100.0, "base_link");
  writeOdometry(100.1, "base_link");
  writeScan(100.05);
  bag_.close();
  const logs::ScanLog log = readBagLog(path_, {"", "", "foo"});
  EXPECT_TRUE(holds(log.notes, "no frame foo in the bag: the base is base_link, as odometry says"));
  EXPECT_EQ(log.records.size(), 1U);
}

TEST_F(BagLog, LeavesOutAndCountsWhatCannotBeUsed) {
  writeMounts();
  writeScan(90.0);
  writeDrive(5);
  writeScan(100.3, "elsewhere");
  const logs::ScanLog log = read();
  EXPECT_EQ(log.records.size(), 5U);
  ASSERT_EQ(log.notes.size(), 3U);
  EXPECT_TRUE(holds(log.notes, "1 x scan without odometry for its stamp"));
  EXPECT_TRUE(holds(log.notes, "scans: nothing for 10.0 s from 0.0 s on"));
}

TEST_F(BagLog, SaysWhatItDidNotFind) {
  writeDrive(3);
  EXPECT_NE(problem().find("holds no usable scan on 'scan' with odometry on '/odom'; 3 x scan"), std::string::npos)
      << problem();
}

TEST_F(BagLog, ReadsOtherTopicsWhenTold) {
  writeMounts();
  writeDrive(3);
  tools::BagTopics topics;
  topics.scan = "/front/scan";
  EXPECT_NE(problem(topics).find("'/front/scan'"), std::string::npos);
  topics.scan = "/scan";
  EXPECT_EQ(readBagLog(path_, topics).records.size(), 3U);
}

TEST_F(BagLog, ChoosesTheScannerWithTheWidestFieldOfViewAndSaysWhich) {
  writeMounts();
  writeDrive(20);
  sensor_msgs::LaserScan narrow;
  narrow.header.frame_id = "camera";
  narrow.angle_increment = 0.1F;
  narrow.ranges.assign(5, 2.0F);
  for (int i = 0; i < 30; ++i) bag_.write("/camera/scan", ros::Time(100.0 + i), narrow);
  const logs::ScanLog log = read();
  EXPECT_EQ(log.records.size(), 20U);
  ASSERT_EQ(log.notes.size(), 1U);
  EXPECT_EQ(log.notes.front().find("scans from scan: of 2 LaserScan topics the widest field of view, 115 deg"), 0U)
      << log.notes.front();
  EXPECT_NE(log.notes.front().find("not /camera/scan (23 deg, 30 scans)"), std::string::npos) << log.notes.front();
}

TEST_F(BagLog, SaysThatTheBagHoldsTheCorrectionOfAnotherMapperAndHoles) {
  writeMounts();
  tf2_msgs::TFMessage corrections;
  corrections.transforms = {mount("map", "odom", 7.0)};
  bag_.write("/tf", ros::Time(100.0), corrections);
  for (int i = 0; i < 100; ++i) {
    if (i > 40 && i < 95) continue;
    writeOdometry(100.0 + 0.1 * i);
    writeScan(100.0 + 0.1 * i);
  }
  const logs::ScanLog log = read();
  EXPECT_TRUE(holds(log.notes, "left out: 1 recorded transforms to odom of another mapper"));
  EXPECT_TRUE(holds(log.notes, "scans: nothing for 5.5 s from 4.0 s on"));
}

// [FLT-1] A slash is no name of a topic, and none of the bag's.
TEST_F(BagLog, FindsNothingOnATopicWithoutAName_FLT_1) {
  writeMounts();
  writeDrive(3);
  for (const char* topic : {"/", "///"}) {
    tools::BagTopics topics;
    topics.scan = topic;
    EXPECT_NE(problem(topics).find("holds no usable scan"), std::string::npos) << topic;
  }
}

TEST_F(BagLog, IsTheSameFromAnotherProcess) {
  writeMounts();
  writeScan(90.0);
  writeDrive(20);
  const logs::ScanLog here = read();
  const logs::ScanLog there = readBagLogApart(path_, {});
  EXPECT_EQ(here.notes, there.notes);
  ASSERT_EQ(here.records.size(), there.records.size());
  for (std::size_t i = 0; i < here.records.size(); ++i) {
    const logs::LogRecord& a = here.records[i];
    const logs::LogRecord& b = there.records[i];
    EXPECT_EQ(a.T_odom_base, b.T_odom_base);
    EXPECT_EQ(a.scan.stamp, b.scan.stamp);
    EXPECT_EQ(a.scan.T_base_sensor, b.scan.T_base_sensor);
    EXPECT_EQ(a.scan.angle_min, b.scan.angle_min);
    EXPECT_EQ(a.scan.angle_increment, b.scan.angle_increment);
    EXPECT_EQ(a.scan.range_min, b.scan.range_min);
    EXPECT_EQ(a.scan.range_max, b.scan.range_max);
    EXPECT_EQ(a.scan.ranges, b.scan.ranges);
  }
}

// [FLT-1] rosbag's own code ends the process on some of these.
TEST_F(BagLog, IsReadOrRefusedWhateverItHolds_FLT_1) {
  writeMounts();
  writeDrive(10);
  bag_.close();
  std::ifstream file(path_, std::ios::binary);
  const std::string whole((std::istreambuf_iterator<char>(file)), {});
  std::mt19937 random(20);
  const auto below = [&](std::size_t limit) {
    return std::uniform_int_distribution<std::size_t>(0, limit - 1)(random);
  };
  BagReadLimits limits;
  limits.time = std::chrono::seconds(5);
  std::size_t refused = 0;
  for (int i = 0; i < 120; ++i) {
    std::string bytes = whole;
    for (std::size_t flips = below(30); flips > 0; --flips) {
      bytes[below(bytes.size())] = static_cast<char>(below(256));
    }
    if (below(3) == 0) bytes.resize(below(bytes.size()));
    if (below(4) == 0) bytes.insert(below(bytes.size() + 1), whole, below(whole.size()), below(500));
    std::ofstream(path_, std::ios::binary) << bytes;
    try {
      readBagLogApart(path_, {}, limits);
    } catch (const logs::LogError& error) {
      ++refused;
      EXPECT_NE(std::string(error.what()).find("drive.bag"), std::string::npos) << error.what();
    }
  }
  EXPECT_GT(refused, 0U);
}

// [FLT-1] Those of scripts/fuzz, and with them all in which it has found a defect.
TEST(BagCorpus, IsReadOrRefused_FLT_1) {
  std::size_t read = 0;
  for (const auto& entry : fs::directory_iterator(std::string(PROJECT_ROOT) + "/test/fuzz/corpus/bags")) {
    try {
      read += readBagLogApart(entry.path().string(), {}).records.size();
    } catch (const logs::LogError& error) {
      EXPECT_NE(std::string(error.what()).find(entry.path().filename().string()), std::string::npos) << error.what();
    }
  }
  EXPECT_GE(read, 12U) << "two bags are whole";
}

// [FLT-1] A compressed bag may be far larger inside than outside.
TEST_F(BagLog, IsRefusedWhenItNeedsTooMuch_FLT_1) {
  writeMounts();
  writeDrive(10);
  bag_.close();
  BagReadLimits limits;
  limits.memory = 1;
  try {
    readBagLogApart(path_, {}, limits);
    FAIL() << "it was read";
  } catch (const logs::LogError& error) {
    EXPECT_NE(std::string(error.what()).find("more memory than"), std::string::npos) << error.what();
  }
  limits = BagReadLimits();
  limits.time = std::chrono::seconds(0);
  try {
    readBagLogApart(path_, {}, limits);
    FAIL() << "it was read";
  } catch (const logs::LogError& error) {
    EXPECT_NE(std::string(error.what()).find("longer than"), std::string::npos) << error.what();
  }
}

// [FLT-1] as a recorder leaves it that was killed
TEST_F(BagLog, SaysWhatMayRecoverABagThatIsCutOff_FLT_1) {
  writeMounts();
  writeDrive(200);
  bag_.close();
  const std::uintmax_t whole = fs::file_size(path_);
  for (const std::uintmax_t size : {whole - 100, whole / 2, std::uintmax_t{13}}) {
    fs::resize_file(path_, size);
    EXPECT_NE(problem().find("'rosbag reindex' may recover what it holds"), std::string::npos) << size << problem();
  }
}

TEST_F(BagLog, SaysThatAMessageIsShorterThanItsType) {
  writeMounts();
  writeDrive(3);
  std_msgs::Bool one_byte;
  sensor_msgs::LaserScan header;
  auto shortened = boost::make_shared<ros::M_string>();
  (*shortened)["type"] = "sensor_msgs/LaserScan";
  (*shortened)["md5sum"] = ros::message_traits::md5sum(header);
  (*shortened)["message_definition"] = ros::message_traits::definition(header);
  (*shortened)["topic"] = "/short";
  bag_.write("/short", ros::Time(100.2), one_byte, shortened);
  tools::BagTopics topics;
  topics.scan = "/short";
  EXPECT_NE(problem(topics).find("is broken: a message is shorter than its type says"), std::string::npos)
      << problem(topics);
}

TEST_F(BagLog, SaysThatAFileIsNoBag) {
  bag_.close();
  std::ofstream(path_) << "#ROSBAG V2.0\nand nothing else";
  EXPECT_THROW(readBagLog(path_, {}), logs::LogError);
  EXPECT_THROW(readBagLog(path_ + ".none", {}), logs::LogError);
  EXPECT_THROW(readBagLogApart(path_, {}), logs::LogError);
  EXPECT_THROW(readBagLogApart(path_ + ".none", {}), logs::LogError);
}

}  // namespace
}  // namespace frontier_pilot
