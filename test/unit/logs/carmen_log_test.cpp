#include "logs/carmen_log.h"

#include <gtest/gtest.h>

#include <sstream>

#include "frontier_pilot/core/motion.h"

namespace frontier_pilot {
namespace {

constexpr double kDegree = kPi / 180.0;

logs::ScanLog readCarmen(const std::string& text, const logs::LogScanner& scanner = {}) {
  std::istringstream file(text);
  return logs::readCarmenLog(file, "drive.log", scanner);
}

std::string problemOfCarmen(const std::string& text) {
  try {
    readCarmen(text);
  } catch (const logs::LogError& error) {
    return error.what();
  }
  return "none";
}

std::string frontLaser(int beams, const std::string& poses, double stamp) {
  std::ostringstream line;
  line << "FLASER " << beams;
  for (int i = 0; i < beams; ++i) line << " 2.5";
  line << " " << poses << " " << stamp << " host 0.1\n";
  return line.str();
}

// The fields as CARMEN's logger writes them: remissions, then two poses, then velocities and safety distances.
constexpr const char* kRobotLaser =
    "ROBOTLASER1 0 -1.570796 3.141593 1.570796 81.9 0.01 1 3 1.5 81.92 4.5 3 10 20 30 1.25 2 0.5 1 2 0.5 0.1 0.2 "
    "0.3 0.4 99.0 100.5 host 0.7\n";

TEST(CarmenLog, ReadsFrontLasers) {
  const logs::ScanLog log =
      readCarmen("# a comment\nPARAM robot_width 0.5\nODOM 1 2 3 4 5 6 7 host 8\n" +
                 frontLaser(180, "1 2 0.5 1 2 0.5", 100.25) + frontLaser(180, "2 2 0.5 2 2 0.5", 100.5));
  ASSERT_EQ(log.records.size(), 2U);
  const logs::LogRecord& first = log.records[0];
  EXPECT_EQ(first.scan.stamp, timeFromSeconds(100.25));
  EXPECT_EQ(first.T_odom_base, Pose2(1.0, 2.0, 0.5));
  EXPECT_EQ(first.scan.T_base_sensor, Pose2());
  EXPECT_EQ(first.scan.ranges.size(), 180U);
  EXPECT_EQ(first.scan.ranges[7], 2.5F);
  EXPECT_EQ(first.scan.range_max, 80.0);
  EXPECT_TRUE(log.notes.empty());
}

TEST(CarmenLog, GivesFrontLasersTheAnglesOfTheScannerWithThatManyBeams) {
  const auto scanOf = [](int beams) { return readCarmen(frontLaser(beams, "0 0 0 0 0 0", 1)).records[0].scan; };
  for (const int beams : {180, 181}) {
    EXPECT_NEAR(scanOf(beams).angle_min, -90.0 * kDegree, 1e-12);
    EXPECT_NEAR(scanOf(beams).angle_increment, kDegree, 1e-12);
  }
  for (const int beams : {360, 361}) EXPECT_NEAR(scanOf(beams).angle_increment, 0.5 * kDegree, 1e-12);
  EXPECT_NEAR(scanOf(401).angle_min, -50.0 * kDegree, 1e-12);
  EXPECT_NEAR(scanOf(401).angle_increment, 0.25 * kDegree, 1e-12);
  EXPECT_NEAR(scanOf(91).angle_increment, 2.0 * kDegree, 1e-12);
}

TEST(CarmenLog, ReadsRobotLasersWithRemissionsAndVelocities) {
  const logs::ScanLog log = readCarmen(kRobotLaser);
  ASSERT_EQ(log.records.size(), 1U);
  const logs::LogRecord& record = log.records[0];
  EXPECT_EQ(record.scan.ranges, (std::vector<float>{1.5F, 81.92F, 4.5F}));
  EXPECT_EQ(record.scan.angle_min, -1.570796);
  EXPECT_EQ(record.scan.angle_increment, 1.570796);
  EXPECT_EQ(record.T_odom_base, Pose2(1.0, 2.0, 0.5));
  EXPECT_EQ(record.scan.stamp, timeFromSeconds(100.5));
  EXPECT_EQ(readBeam(record.scan, 1).kind, RangeKind::kFree) << "beyond the scanner's range is no return";
  const Pose2 mount = Pose2(1.0, 2.0, 0.5).inverse() * Pose2(1.25, 2.0, 0.5);
  EXPECT_FALSE(isJump(record.scan.T_base_sensor, mount, 1e-9, 1e-9));
}

TEST(CarmenLog, TakesTheScannersPlaceFromTheTwoPoses) {
  const logs::ScanLog log =
      readCarmen(frontLaser(181, "1.3 2 0 1 2 0", 1) + frontLaser(181, "1 2.301 1.5708 1 2 1.5708", 2));
  for (const logs::LogRecord& record : log.records) {
    EXPECT_FALSE(isJump(record.scan.T_base_sensor, Pose2(0.3, 0.0, 0.0), 1e-9, 1e-9));
  }
  logs::LogScanner scanner;
  scanner.T_base_sensor = Pose2(0.1, 0.0, 0.0);
  EXPECT_EQ(readCarmen(frontLaser(181, "1.3 2 0 1 2 0", 1), scanner).records[0].scan.T_base_sensor,
            Pose2(0.1, 0.0, 0.0));
}

TEST(CarmenLog, DoesNotTakeCorrectedLaserPosesForTheMount) {
  const logs::ScanLog log = readCarmen(frontLaser(181, "0 0 0 0 0 0", 1) + frontLaser(181, "3 1 0.2 2.5 1.5 0.1", 2));
  EXPECT_EQ(log.records[1].scan.T_base_sensor, Pose2());
  EXPECT_EQ(log.records[1].T_odom_base, Pose2(2.5, 1.5, 0.1));
  ASSERT_EQ(log.notes.size(), 1U);
}

TEST(CarmenLog, ReadsTheKindOfScanThatComesFirst) {
  const logs::ScanLog log =
      readCarmen(frontLaser(181, "0 0 0 0 0 0", 1) + kRobotLaser + frontLaser(181, "1 0 0 1 0 0", 2));
  EXPECT_EQ(log.records.size(), 2U);
  ASSERT_EQ(log.notes.size(), 1U);
  EXPECT_EQ(log.notes[0], "1 scans of another kind than FLASER skipped");
}

TEST(CarmenLog, SaysInWhichLineWhatIsBroken) {
  EXPECT_EQ(problemOfCarmen("\nFLASER 3 1 2\n"), "drive.log:2: has fewer ranges than it says");
  EXPECT_EQ(problemOfCarmen("FLASER 3 1 2 x 0 0 0 0 0 0 1 host 1\n"), "drive.log:1: a range is not a number: 'x'");
  EXPECT_EQ(problemOfCarmen("FLASER three\n"), "drive.log:1: the number of ranges is not a whole number: 'three'");
  EXPECT_EQ(problemOfCarmen("FLASER 2 1 2 0 0 0 0 0\n"), "drive.log:1: ends where the robot's pose should be");
  EXPECT_EQ(problemOfCarmen("FLASER 2 1 2 0 0 0 0 0 0\n"), "drive.log:1: ends where the stamp should be");
  EXPECT_EQ(problemOfCarmen("ROBOTLASER1 0 -1.5 3 0 80 0 0 2 1 1\n"), "drive.log:1: the angular resolution is zero");
  EXPECT_EQ(problemOfCarmen("ROBOTLASER1 0 -1.5 3 1 80 0 0 2 1 1 9 1\n"),
            "drive.log:1: ends where a remission should be");
  EXPECT_EQ(
      problemOfCarmen("ODOM 1 2 3\n"),
      "drive.log: holds no FLASER and no ROBOTLASER1 line, and is no CSV file: its first line should begin with a "
      "number");
  EXPECT_NE(problemOfCarmen("ODOM 1\rODOM 2\n").find("carriage return"), std::string::npos);
}

}  // namespace
}  // namespace frontier_pilot
