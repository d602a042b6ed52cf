#include <algorithm>

#include "frontier_pilot/core/laser_scan.h"
#include "robot_check/checks.h"
#include "robot_check/other_names.h"

namespace frontier_pilot::robot_check {
namespace {

constexpr const char* kScanType = "sensor_msgs/LaserScan";
constexpr const char* kCloudType = "sensor_msgs/PointCloud2";
constexpr double kLeastScanRate = 2.0;  // [Hz]; the navigator stands when the scan is older than 0.5 s
constexpr double kScanLag = 0.1;        // [s] that a stamp may be behind, in addition to the time of a sweep
constexpr double kLeastUsable = 0.1;    // share of the beams
constexpr const char* kMerge =
    "only one scan is used: merge them into one, for example with laserscan_multi_merger of ira_laser_tools, and set "
    "scan:= to the topic of the merged scan";

void checkMissingScan(const Observation& seen, const Expectation& expected, Findings& findings) {
  std::string advice = "start the scanner's driver";
  for (const Topic* cloud : othersOfType(seen.topics, {}, kCloudType)) {
    advice += "; " + cloud->name + " is a point cloud: pointcloud_to_laserscan makes a scan of it";
  }
  const bool elsewhere = isThereUnderAnotherName(seen.topics, expected.scan, kScanType);
  problem(findings, sayMissingTopic(seen.topics, expected.scan, kScanType, "scan"), elsewhere ? "" : advice);
}

void checkScanners(const Observation& seen, const Expectation& expected, const Topic& topic, Findings& findings) {
  if (seen.scan.frames.size() > 1) {
    problem(findings,
            "several scanners publish " + expected.scan + ": frames " + joined(seen.scan.frames) + ", nodes " +
                joined(topic.publishers),
            kMerge);
  } else if (topic.publishers.size() > 1) {
    problem(findings, "several nodes publish " + expected.scan + ": " + joined(topic.publishers),
            std::string("end one of them; if they are two scanners: ") + kMerge);
  }
  std::string others;
  for (const Topic* other : othersOfType(seen.topics, expected.scan, kScanType))
    others += (others.empty() ? "" : ", ") + other->name + " (" + joined(other->publishers) + ")";
  if (!others.empty()) note(findings, "there are other scans, which are not used: " + others, kMerge);
}

/// Says of the times of the beams what the nodes would say. They ask the driver for them only where the robot's file
/// does not give them.
void checkBeamTimes(const ScanStream& seen, const Expectation& expected, Findings& findings) {
  const ScannerModel& scanner = expected.robot.scanner;
  if (seen.rate <= 0.0 || scanner.time_increment >= 0.0) return;
  LaserScan2 scan;
  scan.angle_increment = seen.angle_increment;
  scan.time_increment = seen.time_increment;
  scan.ranges.resize(seen.beams);
  const std::string wrong = BeamTiming::problemOf(scan, 1.0 / seen.rate, scanner.rolling);
  if (wrong.empty()) return;
  note(findings, "the times of the beams of " + expected.scan + " are not credible: " + wrong,
       "set it in the robot's file, or have the driver send the right one; until then all beams are taken as measured "
       "at once, so that the scan is bent while the robot turns");
}

void checkScanContents(const Observation& seen, const Expectation& expected, Findings& findings) {
  const ScanStream& scan = seen.scan;
  const std::string& name = expected.scan;
  if (!scan.problem.empty()) problem(findings, name + " cannot be used: " + scan.problem, "look into its driver");
  if (scan.usable_share < kLeastUsable) {
    problem(findings,
            "only " + number(100.0 * scan.usable_share) + " % of the beams of " + name +
                " measure anything: the rest is " + "NaN or 0",
            "is the scanner covered, or does its driver report nothing at all as 0 instead of inf?");
  }
  if (!scan.stamps_advance)
    problem(findings, "all messages of " + name + " have the same stamp", "the driver has to stamp each one");
  if (scan.rate < kLeastScanRate) {
    problem(findings, name + " comes at " + number(scan.rate) + " Hz",
            "the navigator stands when a scan is older than 0.5 s: at least " + number(kLeastScanRate) + " Hz");
  }
  checkBeamTimes(scan, expected, findings);
  // A scan is stamped when its first beam is measured, and sent after the last one.
  checkLag(seen, scan, name, kScanLag + (scan.rate > 0.0 ? 1.0 / scan.rate : 0.0), findings);
}

}  // namespace

void checkScan(const Observation& seen, const Expectation& expected, Findings& findings) {
  const Topic* topic = findTopic(seen.topics, expected.scan);
  if (topic == nullptr || topic->publishers.empty() || topic->type != kScanType)
    return checkMissingScan(seen, expected, findings);
  if (seen.scan.count == 0) {
    return problem(findings,
                   expected.scan + " is published by " + joined(topic->publishers) + ", but nothing arrived in " +
                       number(seen.seconds) + " s",
                   "does the scanner turn, and does ROS_IP of its computer name an address that this one reaches?");
  }
  checkScanners(seen, expected, *topic, findings);
  checkScanContents(seen, expected, findings);
  if (seen.scan.rate >= kLeastScanRate) {
    good(findings, expected.scan + ": " + number(seen.scan.rate) + " Hz, " + std::to_string(seen.scan.beams) +
                       " beams, from " + joined(topic->publishers));
  }
}

}  // namespace frontier_pilot::robot_check
