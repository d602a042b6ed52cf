#include "logs/csv_log.h"

#include <gtest/gtest.h>

#include <sstream>

namespace frontier_pilot {
namespace {

logs::ScanLog readCsv(const std::string& text, const logs::LogScanner& scanner = {}) {
  std::istringstream file(text);
  return logs::readCsvLog(file, "drive.csv", scanner);
}

std::string problemOfCsv(const std::string& text) {
  try {
    readCsv(text);
  } catch (const logs::LogError& error) {
    return error.what();
  }
  return "none";
}

TEST(CsvLog, ReadsStampOdometryAndRangesFromRightToLeft) {
  const logs::ScanLog log = readCsv("# a comment\n\n10.5,1,2,0.5,3.0,0,7.25\n10.75, -1.5, 2, -0.25, 3, 4, 5\r\n");
  ASSERT_EQ(log.records.size(), 2U);
  const logs::LogRecord& first = log.records[0];
  EXPECT_EQ(first.scan.stamp, timeFromSeconds(10.5));
  EXPECT_EQ(first.T_odom_base, Pose2(1.0, 2.0, 0.5));
  EXPECT_EQ(first.scan.ranges, (std::vector<float>{3.0F, 0.0F, 7.25F}));
  EXPECT_DOUBLE_EQ(first.scan.angle(0), -kPi / 2.0);
  EXPECT_DOUBLE_EQ(first.scan.angle(1), 0.0);
  EXPECT_DOUBLE_EQ(first.scan.angle(2), kPi / 2.0);
  EXPECT_EQ(first.scan.T_base_sensor, Pose2(0.78, 0.0, 0.0));
  EXPECT_EQ(first.scan.range_max, 80.0);
  EXPECT_EQ(log.records[1].T_odom_base, Pose2(-1.5, 2.0, -0.25));
}

TEST(CsvLog, TakesZeroForABeamThatSaysNothing) {
  EXPECT_EQ(readBeam(readCsv("1,0,0,0,0,2\n").records[0].scan, 0).kind, RangeKind::kInvalid);
}

TEST(CsvLog, TakesAnotherScannerWhenTold) {
  logs::LogScanner scanner;
  scanner.T_base_sensor = Pose2(0.1, 0.2, 0.3);
  scanner.range_max = 8.0;
  scanner.field_of_view = kPi / 2.0;
  const LaserScan2 scan = readCsv("1,0,0,0,5,9\n", scanner).records[0].scan;
  EXPECT_EQ(scan.T_base_sensor, Pose2(0.1, 0.2, 0.3));
  EXPECT_DOUBLE_EQ(scan.angle_min, -kPi / 4.0);
  EXPECT_EQ(readBeam(scan, 1).kind, RangeKind::kFree);
}

TEST(CsvLog, SaysInWhichLineWhatIsBroken) {
  EXPECT_EQ(problemOfCsv("1,0,0,0,5,9\n2,0,0\n"), "drive.csv:2: ends where odometry's yaw should be");
  EXPECT_EQ(problemOfCsv("1,0,0,0,5,9\n\n2,0,O,0,5,9\n"), "drive.csv:3: odometry's y is not a number: 'O'");
  EXPECT_EQ(problemOfCsv("1,0,0,0,5,nan\n"), "drive.csv:1: a range is not a number: 'nan'");
  EXPECT_EQ(problemOfCsv("1,0,0,0,5\n"), "drive.csv:1: a scan has at least two ranges");
  EXPECT_EQ(problemOfCsv("1,0,0,0,5,9\n2,0,0,0,5\n"), "drive.csv:2: a scan has at least two ranges");
  EXPECT_EQ(problemOfCsv("1,0,0,0,5,9\n2,0,0,0,5,9,8\n"), "drive.csv:2: has 3 ranges, the first scan has 2");
  EXPECT_EQ(problemOfCsv("# nothing\n"), "drive.csv: holds no scan");
}

}  // namespace
}  // namespace frontier_pilot
