#include <algorithm>

#include "robot_check/checks.h"
#include "robot_check/frame_tree.h"
#include "robot_check/other_names.h"

namespace frontier_pilot::robot_check {
namespace {

constexpr const char* kOdometryType = "nav_msgs/Odometry";
constexpr double kLeastOdometryRate = 5.0;  // [Hz]; below it the pose of a scan is too coarse
constexpr double kOdometryLag = 0.1;        // [s] that a stamp may be behind

bool isTransformThere(const Observation& seen, const Expectation& expected) {
  return transformBetween(seen.links, expected.robot.odom_frame, expected.robot.base_frame).has_value();
}

void checkMissingOdometry(const Observation& seen, const Expectation& expected, Findings& findings) {
  if (othersOfType(seen.topics, expected.odom, kOdometryType).empty() && isTransformThere(seen, expected)) {
    return problem(findings,
                   "nobody publishes " + expected.odom + "; the robot publishes odometry as a transform alone",
                   "set odom:=tf");
  }
  const bool elsewhere = isThereUnderAnotherName(seen.topics, expected.odom, kOdometryType);
  problem(findings, sayMissingTopic(seen.topics, expected.odom, kOdometryType, "odom"),
          elsewhere ? "" : "without odometry nothing can drive: start the base's driver");
}

void checkOdometryContents(const Observation& seen, const Expectation& expected, Findings& findings) {
  const Stream& odometry = seen.odometry;
  const std::string& wanted = expected.robot.odom_frame;
  if (!odometry.problem.empty())
    problem(findings, expected.odom + " cannot be used: " + odometry.problem, "look into the base's driver");
  if (!odometry.stamps_advance)
    problem(findings, "all messages of " + expected.odom + " have the same stamp", "the driver has to stamp each one");
  if (std::find(odometry.frames.begin(), odometry.frames.end(), wanted) == odometry.frames.end()) {
    const std::string frame = odometry.frames.empty() ? "" : odometry.frames.front();
    problem(findings, expected.odom + " is in the frame '" + frame + "', not in " + wanted,
            frame.empty() ? "the driver has to fill in header.frame_id" : "set odom_frame:=" + frame);
  }
  checkLag(seen, odometry, expected.odom, kOdometryLag, findings);
}

}  // namespace

void checkOdometry(const Observation& seen, const Expectation& expected, Findings& findings) {
  if (!expected.robot.hasOdometryTopic()) {
    if (isTransformThere(seen, expected)) good(findings, "odometry: as a transform, as odom:=tf says");
    return;  // checkFrames says what is missing
  }
  const Topic* topic = findTopic(seen.topics, expected.odom);
  if (topic == nullptr || topic->publishers.empty() || topic->type != kOdometryType)
    return checkMissingOdometry(seen, expected, findings);
  if (topic->publishers.size() > 1) {
    problem(findings, "several nodes publish " + expected.odom + ": " + joined(topic->publishers),
            "end one of them, or give it another topic");
  }
  if (seen.odometry.count == 0) {
    return problem(findings,
                   expected.odom + " is published by " + joined(topic->publishers) + ", but nothing arrived in " +
                       number(seen.seconds) + " s",
                   "is the base switched on, and does ROS_IP of its computer name an address that this one reaches?");
  }
  checkOdometryContents(seen, expected, findings);
  const std::string what = expected.odom + ": " + number(seen.odometry.rate) + " Hz from " + joined(topic->publishers);
  if (seen.odometry.rate < kLeastOdometryRate) {
    return note(findings, what + ", which is slow", "at least " + number(kLeastOdometryRate) + " Hz, better 20 Hz");
  }
  good(findings, what);
}

}  // namespace frontier_pilot::robot_check
