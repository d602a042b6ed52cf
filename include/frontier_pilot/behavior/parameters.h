#pragma once

#include "frontier_pilot/core/geometry.h"
#include "frontier_pilot/core/parameters.h"
#include "frontier_pilot/core/robot_model.h"

namespace frontier_pilot::behavior {

/// What has to be free around the robot.
struct FootprintParameters {
  double padding = 0.01;

  template <class Visitor>
  void describe(Visitor& v) {
    v.field("padding", padding, "m", "added to the robot's outline on every side, for the noise of a scan",
            between(0.0, 1.0));
    v.moved("polygon", "robot/outline");
  }
};

/// The costmap that rolls along with the robot.
struct LocalCostmapParameters {
  double side = 3.0;
  double resolution = 0.025;

  template <class Visitor>
  void describe(Visitor& v) {
    v.field("side", side, "m", "of the square window around the robot", between(0.5, 20.0));
    v.field("resolution", resolution, "m", "side of a cell", between(0.005, 0.2));
  }
};

/// How the timed behaviours move; never faster than the robot can.
struct BehaviorParameters {
  RobotModel robot;
  double frequency = 10.0;
  double min_rotational_vel = 0.4;
  double max_rotational_vel = 1.0;
  double linear_acc_lim = 0.6;
  double min_linear_vel = 0.03;
  double default_linear_vel = 0.1;
  double simulate_ahead_time = 2.0;
  double pose_timeout = 0.5;
  double costmap_timeout = 0.5;
  double no_progress_timeout = 2.0;
  double settle_timeout = 0.5;
  double jump_distance = 0.5;
  double jump_angle = 1.5;

  template <class Visitor>
  void describe(Visitor& v) {
    describeRobot(v, robot);
    v.field("frequency", frequency, "Hz", "control cycles a second", between(5.0, 100.0));
    v.field("min_rotational_vel", min_rotational_vel, "rad/s", "slowest turn", positive());
    v.field("max_rotational_vel", max_rotational_vel, "rad/s", "fastest turn", positive());
    v.field("linear_acc_lim", linear_acc_lim, "m/s^2", "a straight motion slows down with", positive());
    v.field("min_linear_vel", min_linear_vel, "m/s", "slowest straight motion", positive());
    v.field("default_linear_vel", default_linear_vel, "m/s", "where a goal asks for none", positive());
    v.field("simulate_ahead_time", simulate_ahead_time, "s", "how far ahead the motion must be free", timeSpan());
    v.field("pose_timeout", pose_timeout, "s", "how old a pose may be", timeSpan());
    v.field("costmap_timeout", costmap_timeout, "s", "how old the last scan in the costmap may be", timeSpan());
    v.field("no_progress_timeout", no_progress_timeout, "s", "a robot that does not come on for so long is stuck",
            timeSpan());
    v.field("settle_timeout", settle_timeout, "s", "longest wait for a standstill before success is told", timeSpan());
    v.field("jump_distance", jump_distance, "m", "a longer step of the pose is a jump", positive());
    v.field("jump_angle", jump_angle, "rad", "a larger turn of the pose at once is a jump", Bounds{0.0, 3.0, true});
    v.moved("rotational_acc_lim", "robot/limits/max_angular_acc");
    v.moved("max_linear_vel", "robot/limits/max_linear");
  }
  void check(Problems& problems) const;
};

}  // namespace frontier_pilot::behavior
