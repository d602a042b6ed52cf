#include "ros/common/messages/scan_motion_report.h"

#include <gtest/gtest.h>

#include <cstddef>

#include "frontier_pilot/core/robot_model.h"
#include "log_lines.h"

namespace frontier_pilot {
namespace {

// [FLT-1] A node that was held up has a second of scans at once that came before their odometry.
TEST(ScanMotionReport, WritesOneLineAboutManyScansThatOdometryDoesNotCover_FLT_1) {
  ScanMotionReport report;
  const LaserScan2 scan;
  const auto note = [&](bool covered, std::size_t times) {
    for (std::size_t i = 0; i < times; ++i) report.note(BeamTiming(ScannerModel{}), covered, scan, Pose2());
  };
  const LogLines log;
  note(false, 5);
  EXPECT_EQ(log.lines.size(), 0U) << "odometry may begin a little later than the scans";
  note(true, 1);
  note(false, 30);
  ASSERT_EQ(log.lines.size(), 1U);
  EXPECT_NE(log.lines.front().second.find("(6 so far)"), std::string::npos) << log.lines.front().second;
}

}  // namespace
}  // namespace frontier_pilot
