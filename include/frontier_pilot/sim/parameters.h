#pragma once

#include <limits>
#include <string>
#include <vector>

#include "frontier_pilot/core/geometry.h"
#include "frontier_pilot/core/parameters.h"
#include "frontier_pilot/core/robot_model.h"

namespace frontier_pilot::sim {

/// The errors of a simulated scanner. Its beams, range and mount are part of the robot's description.
struct LidarNoise {
  double noise_stddev = 0.01;  ///< [m]
  double dropout = 0.0;        ///< share of the beams that give no reading

  template <class Visitor>
  void describe(Visitor& v) {
    v.field("noise_stddev", noise_stddev, "m", "standard deviation of a range", between(0.0, 1000.0));
    v.field("dropout", dropout, "", "share of the beams that give no reading at all", between(0.0, 1.0));
    v.moved("rate", "robot/scanner/rate");
    v.moved("beams", "robot/scanner/beams");
    v.moved("angle_min", "robot/scanner/angle_min");
    v.moved("field_of_view", "robot/scanner/field_of_view");
    v.moved("range_min", "robot/scanner/range_min");
    v.moved("range_max", "robot/scanner/range_max");
    v.moved("mount_x", "robot/scanner/x");
    v.moved("mount_y", "robot/scanner/y");
    v.moved("mount_yaw", "robot/scanner/yaw");
  }
};

/// Odometry noise by the odometry motion model of Thrun, Burgard & Fox, "Probabilistic Robotics", 5.4, with AMCL's
/// names. In the book the variance of one update grows with the square of its motion, so the total over a path depends
/// on the update rate. Here it grows with the motion itself, and equals the book's for a motion of one metre or radian.
struct OdometryParameters {
  double alpha1 = 0.0005;  ///< [rad^2/rad]
  double alpha2 = 0.0002;  ///< [rad^2/m]
  double alpha3 = 0.0005;  ///< [m^2/m]
  double alpha4 = 0.0001;  ///< [m^2/rad]
  // Standard deviations of the systematic errors of a badly calibrated base, which are drawn once for each robot.
  double distance_scale = 0.0;  ///< [m/m]
  double turn_scale = 0.0;      ///< [rad/rad]
  double drift = 0.0;           ///< [rad/m]

  template <class Visitor>
  void describe(Visitor& v) {
    v.field("alpha1", alpha1, "rad^2/rad", "variance of the yaw per radian turned", between(0.0, 1000.0));
    v.field("alpha2", alpha2, "rad^2/m", "variance of the yaw per metre driven", between(0.0, 1000.0));
    v.field("alpha3", alpha3, "m^2/m", "variance of the distance per metre driven", between(0.0, 1000.0));
    v.field("alpha4", alpha4, "m^2/rad", "variance of the distance per radian turned", between(0.0, 1000.0));
    v.field("distance_scale", distance_scale, "m/m", "standard deviation of a constant error per metre driven",
            between(0.0, 1000.0));
    v.field("turn_scale", turn_scale, "rad/rad", "standard deviation of a constant error per radian turned",
            between(0.0, 1000.0));
    v.field("drift", drift, "rad/m", "standard deviation of a constant turn per metre driven", between(0.0, 1000.0));
  }
};

/// One robot of several: its name (its namespace) and start pose in the world's frame.
struct RobotSpec {
  std::string name;
  double x = 0.0;          ///< [m]
  double y = 0.0;          ///< [m]
  double yaw = 0.0;        ///< [rad]
  std::string robot = {};  ///< the name of its RobotKind; empty: the model of the parameters

  template <class Visitor>
  void describe(Visitor& v) {
    v.field("name", name, "", "namespace of the robot; empty for none");
    v.field("x", x, "m", "start in the world's frame", coordinate());
    v.field("y", y, "m", "start in the world's frame", coordinate());
    v.field("yaw", yaw, "rad", "start in the world's frame", coordinate());
    v.field("robot", robot, "", "name of one of the `kinds`; empty: the robot that the group `robot` describes");
  }
};

/// A model that several robots may have.
struct RobotKind {
  std::string name;
  RobotModel robot;

  template <class Visitor>
  void describe(Visitor& v) {
    v.field("name", name, "", "what the list `robots` calls it");
    describeRobot(v, robot);
  }
};

/// The parameters of a simulation. x, y and yaw are NaN if not given. What is not given is 0, or, if neither x nor y
/// is, that of the world's start pose if it has one, and otherwise the free place nearest to the middle of the world. A
/// yaw that is given always counts.
struct SimulatorParameters {
  std::string world;
  double x = std::numeric_limits<double>::quiet_NaN();    ///< [m]
  double y = std::numeric_limits<double>::quiet_NaN();    ///< [m]
  double yaw = std::numeric_limits<double>::quiet_NaN();  ///< [rad]
  double speed = 1.0;
  int seed = 1;
  bool odom_noise = false;
  bool unknown_is_free = false;
  RobotModel robot;  ///< the model of all robots that are of no other kind
  LidarNoise lidar;
  OdometryParameters odometry;
  std::vector<RobotKind> kinds;
  std::vector<RobotSpec> robots;

  template <class Visitor>
  void describe(Visitor& v) {
    v.field("world", world, "", "map_server YAML of the world; required");
    v.field("x", x, "m",
            "start in the world's frame; without x and y: the world's start, or the free place nearest to the middle",
            coordinate());
    v.field("y", y, "m",
            "start in the world's frame; without x and y: the world's start, or the free place nearest to the middle",
            coordinate());
    v.field("yaw", yaw, "rad", "start in the world's frame; without x, y and yaw: the world's start, or 0",
            coordinate());
    v.field("speed", speed, "", "simulated time over real time; 0: as fast as possible", between(0.0, 1e4));
    v.field("seed", seed, "", "seed of all noise; the same seed and commands give the same output, byte by byte",
            countFrom(0));
    v.field("odom_noise", odom_noise, "", "whether the odometry drifts");
    v.field("unknown_is_free", unknown_is_free, "",
            "whether unknown cells of the world can be driven and seen through");
    describeRobot(v, robot);
    LidarGroup scanners{lidar, robot.scanner.rolling};
    v.group("lidar", scanners, "the simulated scanners");
    v.group("odometry", odometry, "odometry noise");
    v.list("kinds", kinds, "models of robots, in addition to that of the group `robot`");
    v.list("robots", robots, "several robots, instead of one at x, y, yaw");
    v.moved("radius", "robot/disc_radius");
    v.moved("command_timeout", "robot/watchdog");
  }

  void check(Problems& problems) const;

 private:
  /// The group `lidar`: noise, and `rolling`, which overrides robot/scanner/rolling.
  struct LidarGroup {
    LidarNoise& noise;
    bool& rolling;

    template <class Visitor>
    void describe(Visitor& v) {
      noise.describe(v);
      v.field("rolling", rolling, "",
              "whether scanners measure one beam after the other; overrides robot/scanner/rolling, but not that of "
              "`kinds`");
    }
  };
};

}  // namespace frontier_pilot::sim
