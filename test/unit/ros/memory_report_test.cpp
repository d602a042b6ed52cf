// When it is said that something would not survive a node. [FLT-2]

#include "ros/common/memory/memory_report.h"

#include <diagnostic_msgs/DiagnosticStatus.h>
#include <gtest/gtest.h>

#include <chrono>

#include "ros/common/memory/disk.h"

namespace frontier_pilot {
namespace {

SteadyTime at(int seconds) { return SteadyTime(std::chrono::seconds(1000 + seconds)); }

diagnostic_updater::DiagnosticStatusWrapper statusOf(const MemoryReport& report) {
  diagnostic_updater::DiagnosticStatusWrapper status;
  report.report(status);
  return status;
}

// [FLT-2]
TEST(MemoryReport, SaysAtOnceThatAFileCannotBeWritten) {
  MemoryReport report;
  EXPECT_EQ(report.setProblem("the map", "cannot write it", at(0)), "cannot write it");
  EXPECT_EQ(statusOf(report).message, "the map would not survive this node: cannot write it");
  EXPECT_EQ(report.setProblem("the map", "", at(1)), "");
  EXPECT_EQ(statusOf(report).level, diagnostic_msgs::DiagnosticStatus::OK);
}

// On a busy computer a thread does not always get its time within 50 ms, and the disk is healthy. [FLT-2]
TEST(MemoryReport, SaysNothingOfAWriteThatIsOnlyLate) {
  MemoryReport report;
  for (int second = 0; second < 20; second += 2) {
    EXPECT_EQ(report.setProblem("the map", kSilentDisk, at(second)), "");
    EXPECT_EQ(statusOf(report).level, diagnostic_msgs::DiagnosticStatus::OK);
    EXPECT_EQ(report.setProblem("the map", "", at(second + 1)), "");
  }
}

// [FLT-2]
TEST(MemoryReport, SaysThatADiskDoesNotAnswerOnceItHasBeenSoForFiveSeconds) {
  MemoryReport report;
  for (int second = 0; second < 5; ++second) EXPECT_EQ(report.setProblem("the map", kSilentDisk, at(second)), "");
  EXPECT_EQ(report.setProblem("orders", kSilentDisk, at(5)), "");
  EXPECT_EQ(report.setProblem("the map", kSilentDisk, at(5)), kSilentDisk);
  EXPECT_EQ(statusOf(report).level, diagnostic_msgs::DiagnosticStatus::WARN);
  EXPECT_EQ(statusOf(report).message, "the map would not survive this node: the disk does not answer");
  report.setProblem("the map", "", at(6));
  EXPECT_EQ(statusOf(report).level, diagnostic_msgs::DiagnosticStatus::OK);
}

}  // namespace
}  // namespace frontier_pilot
