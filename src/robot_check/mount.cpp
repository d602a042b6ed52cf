#include <algorithm>
#include <cmath>

#include "frontier_pilot/core/bounds.h"
#include "frontier_pilot/core/laser_scan.h"
#include "robot_check/checks.h"
#include "robot_check/frame_tree.h"

namespace frontier_pilot::robot_check {
namespace {

constexpr double kMostTilt = 10.0;  // [deg] of a scanner whose scans the nodes use
constexpr double kOutside = 0.05;   // [m] beyond the outline
constexpr double kDegrees = 180.0 / kPi;

std::string describe(const Eigen::Isometry3d& T_base_sensor) {
  const Eigen::Vector3d at = T_base_sensor.translation();
  const Eigen::Vector3d ahead = T_base_sensor.linear().col(0);
  const double yaw = std::atan2(ahead.y(), ahead.x()) * kDegrees;
  const bool upside_down = T_base_sensor.linear()(2, 2) < 0.0;
  return number(std::abs(at.x())) + " m " + (at.x() < 0.0 ? "behind" : "ahead of") + " the base's origin, " +
         number(std::abs(at.y())) + " m to the " + (at.y() < 0.0 ? "right" : "left") + ", " + number(at.z()) +
         " m up, turned by " + std::to_string(std::lround(yaw)) + " deg" + (upside_down ? ", upside down" : "");
}

/// `scan`, which is in the scanner's own frame, as of a scanner that is mounted there.
LaserScan2 mounted(LaserScan2 scan, const Eigen::Isometry3d& T_base_sensor) {
  const Eigen::Matrix3d R = T_base_sensor.linear();
  if (R(2, 2) < 0.0) {
    scan.angle_min = -scan.angle_min;
    scan.angle_increment = -scan.angle_increment;
  }
  scan.T_base_sensor =
      Pose2(T_base_sensor.translation().x(), T_base_sensor.translation().y(), std::atan2(R(1, 0), R(0, 0)));
  return scan;
}

void checkView(const Observation& seen, const Expectation& expected, const Eigen::Isometry3d& T_base_sensor,
               Findings& findings) {
  if (!seen.scan.last || looksAhead(mounted(*seen.scan.last, T_base_sensor))) return;
  problem(findings,
          expected.scan +
              " does not show what is ahead: no beam within 30 degrees of straight ahead, hardly one of those that "
              "measures anything, or a range_max below 0.5 m",
          "nothing drives by such a scan: correct the yaw of the scanner's mount in TF, or look into its driver");
}

void checkPlace(const Eigen::Isometry3d& T_base_sensor, const RobotModel& robot, Findings& findings) {
  const double tilt = std::acos(std::min(1.0, std::abs(T_base_sensor.linear()(2, 2)))) * kDegrees;
  if (tilt > kMostTilt) {
    return problem(
        findings, "the scanner is tilted by " + std::to_string(std::lround(tilt)) + " deg by TF",
        "its beams have to lie in a plane parallel to the floor: correct the transform, which may be that of a "
        "camera's optical frame");
  }
  const double distance = T_base_sensor.translation().norm();
  if (!bounds::isWithin(distance, bounds::kMostMount)) {
    return problem(
        findings, "by TF the scanner is " + number(distance) + " m from the base's origin",
        "the nodes refuse scans from farther than " + number(bounds::kMostMount) + " m: is the transform in metres?");
  }
  const Vec2 at(T_base_sensor.translation().x(), T_base_sensor.translation().y());
  const double outside = robot.exactOutline().distance(at);
  if (outside > kOutside) {
    note(findings, "by TF the scanner is " + number(outside) + " m outside of the robot's outline",
         "is robot:= the right one, and the transform in metres from the wheel axis?");
  }
  good(findings, "the scanner's mount: " + describe(T_base_sensor));
}

}  // namespace

void checkMount(const Observation& seen, const Expectation& expected, Findings& findings) {
  if (seen.scan.count == 0 || seen.scan.frames.empty()) return;  // checkScan says so
  const std::string& frame = seen.scan.frames.front();
  const std::string& base = expected.robot.base_frame;
  if (frame.empty()) {
    return problem(findings, expected.scan + " has no frame: its header.frame_id is empty",
                   "set the frame in the scanner's driver (often the parameter frame_id)");
  }
  if (frame == expected.robot.odom_frame || frame == expected.map_frame) {
    return problem(findings, expected.scan + " is in the frame " + frame + ", which does not move with the robot",
                   "set the scanner's own frame in its driver (often the parameter frame_id)");
  }
  const std::set<std::string> frames = framesOf(seen.links);
  if (frames.count(base) == 0) return;  // checkFrames says so
  const auto T_base_sensor = transformBetween(seen.links, base, frame);
  if (T_base_sensor) {
    checkView(seen, expected, *T_base_sensor, findings);
    return checkPlace(*T_base_sensor, expected.robot, findings);
  }
  problem(findings, "the frame " + frame + " of " + expected.scan + " is not connected to " + base + " in TF",
          "publish where the scanner is mounted: rosrun tf2_ros static_transform_publisher X Y Z YAW PITCH ROLL " +
              base + " " + frame);
}

}  // namespace frontier_pilot::robot_check
