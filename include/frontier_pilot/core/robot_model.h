#pragma once

#include <string>
#include <vector>

#include "frontier_pilot/core/bounds.h"
#include "frontier_pilot/core/geometry.h"
#include "frontier_pilot/core/outline.h"
#include "frontier_pilot/core/parameters.h"

namespace frontier_pilot {

/// What a differential drive can do. Defaults: TurtleBot3 Burger (maker's data sheet).
struct RobotLimits {
  double max_linear = 0.22;      ///< [m/s], forward and in reverse
  double max_angular = 2.84;     ///< [rad/s]
  double max_linear_acc = 2.5;   ///< [m/s^2]
  double max_angular_acc = 3.2;  ///< [rad/s^2]

  template <class Visitor>
  void describe(Visitor& v) {
    v.field("max_linear", max_linear, "m/s", "greatest speed, forward and in reverse", baseSpeed());
    v.field("max_angular", max_angular, "rad/s", "greatest rate of turn", baseTurnRate());
    v.field("max_linear_acc", max_linear_acc, "m/s^2", "greatest change of speed", baseAcceleration());
    v.field("max_angular_acc", max_angular_acc, "rad/s^2", "greatest change of the rate of turn", baseAcceleration());
  }
};

/// `twist` with its linear and its angular part clamped to the speed limits, independently of each other.
Twist2 clamp(const Twist2& twist, const RobotLimits& limits);

/// The twist nearest to `target` that can be reached from `from` in `seconds` [s] under the acceleration limits.
Twist2 limitAcceleration(const Twist2& target, const Twist2& from, const RobotLimits& limits, double seconds);

/// A planar scanner and where it is mounted. Defaults: beams and mount of the TurtleBot3 Burger's scanner, but with a
/// range of 8 m instead of 3.5 m.
struct ScannerModel {
  double x = -0.032;                 ///< [m], in the base frame
  double y = 0.0;                    ///< [m]
  double yaw = 0.0;                  ///< [rad]
  double rate = 10.0;                ///< [Hz]
  int beams = 360;                   ///< spread evenly over the field of view
  double angle_min = 0.0;            ///< [rad], of the first beam, in the scanner's frame
  double field_of_view = 2.0 * kPi;  ///< [rad]; on a full turn the last beam is one step short of the first
  double range_min = 0.12;           ///< [m]
  double range_max = 8.0;            ///< [m]
  bool rolling = false;              ///< it measures one beam after the other over the whole period of a scan
  double time_increment = -1.0;      ///< from one beam to the next [s]; negative: as the driver says
  bool reversed = false;             ///< whether it measures the last beam first

  Pose2 T_base_sensor() const { return {x, y, yaw}; }

  template <class Visitor>
  void describe(Visitor& v) {
    v.field("x", x, "m", "where the scanner sits, ahead of the base's origin", between(-5.0, 5.0));
    v.field("y", y, "m", "where the scanner sits, to the left of the base's origin", between(-5.0, 5.0));
    v.field("yaw", yaw, "rad", "which way the scanner looks", between(-2.0 * kPi, 2.0 * kPi));
    v.field("rate", rate, "Hz", "scans per second", between(0.1, 100.0));
    v.field("beams", beams, "", "number of beams, spread evenly over the field of view",
            between(1, static_cast<int>(bounds::kMostRanges)));
    v.field("angle_min", angle_min, "rad", "angle of the first beam in the scanner's frame",
            between(-2.0 * kPi, 2.0 * kPi));
    v.field("field_of_view", field_of_view, "rad", "angle that the beams cover", {0.0, 2.0 * kPi, true});
    v.field("range_min", range_min, "m", "nearest distance it measures", scanRangeOrNone());
    v.field("range_max", range_max, "m", "farthest distance it measures", scanRange());
    v.field("rolling", rolling, "", "whether it measures one beam after the other, over the whole period of a scan");
    v.field("time_increment", time_increment, "s",
            "time from one beam to the next; 0: all beams are measured at once; -1: the one that the driver gives",
            between(-1.0, 1.0));
    v.field("reversed", reversed, "", "whether the last beam of a scan is measured first, and the first one last");
  }
  void check(Problems& problems) const;
};

/// The description of a robot that every node reads: its outline, limits, scanner, watchdog and frames. The files in
/// config/robots/ are such descriptions. Defaults: TurtleBot3 Burger, by its data sheet. [ROB-1]
struct RobotModel {
  std::vector<double> outline = {0.037, 0.089, -0.101, 0.089, -0.101, -0.089, 0.037, -0.089};  ///< x1, y1, ... [m]
  double disc_radius = 0.105;                                                                  ///< [m]; 0: no disc
  RobotLimits limits;
  ScannerModel scanner;
  double watchdog = 0.6;           ///< [s]
  std::string odometry = "topic";  ///< or "tf": the robot publishes only the transform from odom to base
  std::string base_frame = "base_footprint";
  std::string odom_frame = "odom";

  /// The polygon, or the disc if there is none. Throws std::invalid_argument where `check` finds a problem with it.
  Outline exactOutline() const;
  /// What has to be kept clear while driving: the disc if there is one (`disc_radius` > 0), otherwise the polygon.
  Outline drivenOutline() const { return disc_radius > 0.0 ? Outline::disc(disc_radius) : exactOutline(); }
  bool hasOdometryTopic() const { return odometry == "topic"; }
  /// The base frame of a node whose own parameter is `own`: that, or the robot's if it is empty.
  const std::string& baseFrameOr(const std::string& own) const { return own.empty() ? base_frame : own; }
  /// Likewise for the frame of odometry.
  const std::string& odomFrameOr(const std::string& own) const { return own.empty() ? odom_frame : own; }
  /// Adds a problem if `frame`, a node's parameter called `name`, is the base frame of that node, whose own parameter
  /// is `own_base`: between a frame and itself there is no transform that could say where the robot is. [FLT-1]
  void checkIsNotBase(Problems& problems, const std::string& name, const std::string& frame,
                      const std::string& own_base) const;

  template <class Visitor>
  void describe(Visitor& v) {
    v.field("outline", outline, "m", "corners x1, y1, x2, y2, ... in the base frame, in order; empty: the disc alone",
            between(-5.0, 5.0));
    v.field(
        "disc_radius", disc_radius, "m",
        "radius of a disc about the base's origin that replaces the outline of a round robot while it drives; 0: the "
        "outline itself is checked along the path",
        between(0.0, 5.0));
    v.group("limits", limits, "what the base can do");
    v.group("scanner", scanner, "the laser scanner");
    v.field("watchdog", watchdog, "s", "a base that has received no command for this long stops", timeSpan());
    v.field("odometry", odometry, "",
            "topic: the robot publishes odom; tf: it publishes only the transform from odom_frame to base_frame");
    v.field("base_frame", base_frame, "", "frame between the wheels, on the floor", FrameName::kGiven);
    v.field("odom_frame", odom_frame, "", "frame of odometry", FrameName::kGiven);
  }
  void check(Problems& problems) const;
};

/// Loads the description of a robot, a file like those in config/robots/. Throws std::invalid_argument listing every
/// problem with it.
RobotModel loadRobot(const std::string& path);

/// Describes the robot as the parameter group `robot` of a node, and as a group `limits` that overrides robot/limits.
template <class Visitor>
void describeRobot(Visitor& v, RobotModel& robot) {
  v.group("robot", robot, "the robot, see config/robots/");
  v.alias("limits", robot.limits);
}

}  // namespace frontier_pilot
