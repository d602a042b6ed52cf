#include "frontier_pilot/logs/scan_log.h"

#include <gtest/gtest.h>

#include <sstream>

namespace frontier_pilot {
namespace {

logs::LogFormat formatOfText(const std::string& text) {
  std::istringstream file(text);
  return logs::formatOf(file);
}

std::size_t recordsOf(const std::string& text) {
  std::istringstream file(text);
  return logs::readScanLog(file, "drive").records.size();
}

TEST(ScanLog, KnowsAFormatByItsFirstLine) {
  EXPECT_EQ(formatOfText("1137834225.9,0,0,0,1.6,1.7\n"), logs::LogFormat::kCsv);
  EXPECT_EQ(formatOfText("# a comment\n\n -1.5,0,0,0,1.6,1.7\n"), logs::LogFormat::kCsv);
  EXPECT_EQ(formatOfText("# message_name [message contents]\nPARAM a, 1\n"), logs::LogFormat::kCarmen);
  EXPECT_EQ(formatOfText(""), logs::LogFormat::kCarmen);
  for (const char* bag : {"#ROSBAG V2.0\n", "#ROSBAG V1.0\n", "#ROSRECORD V1.1\n", "#ROSLOG V1.1\n"}) {
    EXPECT_EQ(formatOfText(bag), logs::LogFormat::kRosbag) << bag;
  }
}

TEST(ScanLog, ReadsWhatItKnows) {
  EXPECT_EQ(recordsOf("1,0,0,0,1.6,1.7\n2,0,0,0,1.6,1.7\n"), 2U);
  EXPECT_EQ(recordsOf("FLASER 2 1 2 0 0 0 0 0 0 5 host 1\n"), 1U);
}

TEST(ScanLog, LosesNothingToTheMarkWithWhichSomeEditorsBeginAFile) {
  const std::string mark = "\xEF\xBB\xBF";
  EXPECT_EQ(recordsOf(mark + "1,0,0,0,1.6,1.7\n2,0,0,0,1.6,1.7\n"), 2U);
  EXPECT_EQ(recordsOf(mark + "FLASER 2 1 2 0 0 0 0 0 0 5 host 1\nFLASER 2 1 2 0 0 0 0 0 0 6 host 1\n"), 2U);
}

// [FLT-1] The distance from base to scanner sizes the mapper's grids, whether a message or a log says it.
TEST(ScanLog, RefusesALaserOrAPoseThatIsTooFarAway_FLT_1) {
  EXPECT_EQ(recordsOf("FLASER 2 1 2 9 0 0 0 0 0 5 host 1\n"), 1U);
  EXPECT_THROW(recordsOf("FLASER 2 1 2 1e9 1e9 0 0 0 0 5 host 1\n"), logs::LogError);
  EXPECT_THROW(recordsOf("FLASER 2 1 2 50000 0 0 0 0 0 5 host 1\n"), logs::LogError);
  EXPECT_THROW(recordsOf("FLASER 2 1 2 1e8 0 0 1e8 0 0 5 host 1\n"), logs::LogError);
  EXPECT_THROW(recordsOf("1,0,-2e6,0,1.6,1.7\n"), logs::LogError);
  std::istringstream far("ROBOTLASER1 0 -1.5 3.0 3.0 4e9 0.01 1 2 4e9 5e4 0 0 0 0 0 0 0 0 0 0 0 0 1.0 host 0\n");
  const logs::ScanLog log = logs::readScanLog(far, "drive");
  ASSERT_EQ(log.records.size(), 1U);
  EXPECT_EQ(readBeam(log.records[0].scan, 0).kind, RangeKind::kFree) << "longer than a scanner sees is no return";
  EXPECT_EQ(readBeam(log.records[0].scan, 0).distance, 100.0);
}

void expectOneDrive(const std::string& text) {
  std::istringstream file(text);
  logs::requireOneDrive(logs::readScanLog(file, "drive"), "drive");
}

// [FLT-1] Two drives in one file would become one map, in which loops are closed between the two.
TEST(ScanLog, MustBeOneDrive_FLT_1) {
  EXPECT_NO_THROW(expectOneDrive("5,0,0,0,1.6,1.7\n4.2,0,0,0,1.6,1.7\n6,0,0,0,1.6,1.7\n"))
      << "stamps go back a little in logs of real robots";
  EXPECT_THROW(expectOneDrive("1,0,0,0,1.6,1.7\n20,0,0,0,1.6,1.7\n1,0,0,0,1.6,1.7\n"), logs::LogError);
}

// [FLT-1] All but the first would be left out as copies, and the map of one scan be called that of the drive.
TEST(ScanLog, MustHaveMoreThanOneStamp_FLT_1) {
  EXPECT_NO_THROW(expectOneDrive("5,0,0,0,1.6,1.7\n"));
  EXPECT_THROW(expectOneDrive("5,0,0,0,1.6,1.7\n5,1,0,0,1.6,1.7\n"), logs::LogError);
}

TEST(ScanLog, SaysThatItCannotReadARosbag) { EXPECT_THROW(recordsOf("#ROSBAG V2.0\n"), logs::LogError); }

}  // namespace
}  // namespace frontier_pilot
