#include "ros/common/inputs/topic_input.h"

#include <gtest/gtest.h>

#include "ros/common/inputs/input_watch.h"

namespace frontier_pilot {
namespace {

using diagnostic_msgs::DiagnosticStatus;

constexpr const char* kScanType = "sensor_msgs/LaserScan";

SteadyTime after(double seconds) { return SteadyTime{} + fromSeconds(seconds); }
Time at(double seconds) { return Time{} + fromSeconds(1000.0 + seconds); }

/// What the diagnostics of `input` say at `seconds`.
diagnostic_updater::DiagnosticStatusWrapper said(const TopicInput& input, double seconds) {
  diagnostic_updater::DiagnosticStatusWrapper status;
  status.summary(DiagnosticStatus::OK, "");
  input.report(status, after(seconds), false);
  return status;
}

/// Ten seconds of scans at 10 Hz whose stamps are `lag` [s] behind.
TopicInput scansThatAreLateBy(double lag) {
  TopicInput input("scan", kScanType);
  for (double t = 0.0; t < 10.0; t += 0.1) input.admit({"/lidar", "laser", at(t - lag)}, after(t), at(t));
  return input;
}

// [ROB-2]
TEST(TopicInput, ASecondScannerIsRefusedWithTheWayToMergeThem_ROB_2) {
  TopicInput input("scan", kScanType);
  EXPECT_TRUE(input.admit({"/front", "front_laser", at(0.0)}, after(0.0), at(0.0)));
  EXPECT_FALSE(input.admit({"/rear", "rear_laser", at(0.1)}, after(0.1), at(0.1)));
  EXPECT_TRUE(input.admit({"/front", "front_laser", at(0.2)}, after(0.2), at(0.2)));
  const auto status = said(input, 0.3);
  EXPECT_EQ(status.level, DiagnosticStatus::ERROR);
  EXPECT_NE(status.message.find("front_laser of /front is used, rear_laser of /rear is refused: merge them"),
            std::string::npos)
      << status.message;
}

// [FLT-1]
TEST(TopicInput, AScanThatCannotBeUsedIsLeftToTheNodeToRefuse_FLT_1) {
  TopicInput input("scan", kScanType);
  EXPECT_TRUE(input.admit({"/front", "front_laser", at(0.0)}, after(0.0), at(0.0)));
  EXPECT_TRUE(input.admit({"/rear", "nowhere", at(0.1)}, after(0.1), at(0.1), [] { return false; }));
  EXPECT_EQ(input.frame(), "front_laser");
  EXPECT_FALSE(input.admit({"/rear", "rear_laser", at(0.2)}, after(0.2), at(0.2), [] { return true; }));
}

// [ROB-2]
TEST(TopicInput, AScannerThatFellSilentIsReplacedByAnotherOne_ROB_2) {
  TopicInput input("scan", kScanType);
  EXPECT_TRUE(input.admit({"/front", "front_laser", at(0.0)}, after(0.0), at(0.0)));
  EXPECT_TRUE(input.admit({"/rear", "rear_laser", at(4.0)}, after(4.0), at(4.0)));
}

// [ROB-2]
TEST(TopicInput, StampsATenthOfASecondAheadOrBehindAreTolerated_ROB_2) {
  for (const double lag : {-0.09, 0.0, 0.09})
    EXPECT_EQ(said(scansThatAreLateBy(lag), 10.0).level, DiagnosticStatus::OK);
}

// [ROB-2]
TEST(TopicInput, ClocksThatDifferAreMeasuredAndNamed_ROB_2) {
  const TopicInput ahead = scansThatAreLateBy(-0.4);
  EXPECT_NEAR(ahead.lag().value(), -0.4, 1e-6);
  EXPECT_NE(said(ahead, 10.0).message.find("the stamps of scan are 0.40 s ahead"), std::string::npos);
  EXPECT_NE(said(scansThatAreLateBy(0.5), 10.0).message.find("0.50 s late"), std::string::npos);
}

// [ROB-3]
TEST(TopicInput, IsFoundUnderAnotherName_ROB_3) {
  const TopicInput input("/scan", kScanType);
  const std::vector<robot_check::Topic> topics = {{"/base_scan", kScanType, {"/lidar"}, {}}};
  EXPECT_EQ(input.missing(topics, after(0.0), at(0.0)),
            "nobody publishes /scan; /base_scan is a sensor_msgs/LaserScan of /lidar: set /scan:=/base_scan");
  EXPECT_EQ(input.missing({}, after(0.0), at(0.0)), "nothing arrives on /scan");
  EXPECT_EQ(input.missing({{"/scan", kScanType, {"/lidar"}, {}}}, after(0.0), at(0.0)),
            "/scan is published by /lidar, but nothing arrives");
}

// [ROB-3]
TEST(TopicInput, IsNotMissingWhileASimulationIsPausedOrSlow_ROB_3) {
  TopicInput input("/scan", kScanType);
  input.admit({"/lidar", "laser", at(0.0)}, after(0.0), at(0.0));
  EXPECT_EQ(input.missing({}, after(60.0), at(0.1)), "");
  EXPECT_EQ(input.missing({}, after(2.0), at(60.0)), "");
  EXPECT_NE(input.missing({}, after(4.0), at(4.0)), "");
}

// [ROB-3]
TEST(InputWatch, IsReadyWhenNothingIsMissingAndWarnsAfterTwoSeconds_ROB_3) {
  InputWatch watch;
  std::string missing = "no frame base_footprint";
  watch.need([&](const InputWatch::Topics&) { return missing; });
  EXPECT_FALSE(watch.ready());
  for (const double t : {0.0, 1.0, 2.0}) watch.look({}, after(t));
  diagnostic_updater::DiagnosticStatusWrapper status;
  status.summary(DiagnosticStatus::OK, "");
  watch.report(status);
  EXPECT_EQ(status.level, DiagnosticStatus::WARN);
  EXPECT_EQ(watch.missing(), missing);
  missing.clear();
  watch.look({}, after(3.0));
  EXPECT_TRUE(watch.ready());
}

}  // namespace
}  // namespace frontier_pilot
