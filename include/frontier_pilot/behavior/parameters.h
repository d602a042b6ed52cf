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

/// The rolling costmap around the robot.
struct LocalCostmapParameters {
  static constexpr double kMostSide = 20.0;  // [m]
  double side = 3.0;
  double resolution = 0.025;

  template <class Visitor>
  void describe(Visitor& v) {
    v.field("side", side, "m",
            "side of the square window around the robot; larger where the look ahead at the robot's speed needs it",
            between(0.5, kMostSide));
    v.field("resolution", resolution, "m", "side of a cell of the costmap", between(0.005, 0.2));
  }
};

/// How the timed behaviours move; the robot's limits apply as well.
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
    v.field("frequency", frequency, "Hz", "control cycles per second", between(5.0, 100.0));
    v.field("min_rotational_vel", min_rotational_vel, "rad/s", "least rate of turn", baseTurnRate());
    v.field("max_rotational_vel", max_rotational_vel, "rad/s", "greatest rate of turn", baseTurnRate());
    v.field("linear_acc_lim", linear_acc_lim, "m/s^2", "deceleration at the end of a straight motion",
            baseAcceleration());
    v.fixed({"min_linear_vel"});
    v.field("default_linear_vel", default_linear_vel, "m/s", "speed of a straight motion whose goal names none",
            baseSpeed());
    v.field("simulate_ahead_time", simulate_ahead_time, "s",
            "how far ahead, in time, the motion must be free of obstacles", positiveUpTo(30.0));
    v.field("pose_timeout", pose_timeout, "s", "greatest age of the robot's pose", dataAge());
    v.field("costmap_timeout", costmap_timeout, "s", "greatest age of the last scan in the costmap", dataAge());
    v.field("no_progress_timeout", no_progress_timeout, "s", "time without progress after which a motion is given up",
            timeSpan());
    v.fixed({"settle_timeout", "jump_distance", "jump_angle"});
    v.moved("rotational_acc_lim", "robot/limits/max_angular_acc");
    v.moved("max_linear_vel", "robot/limits/max_linear");
    v.tunable({"max_rotational_vel", "default_linear_vel", "linear_acc_lim", "limits/max_linear",
               "limits/max_linear_acc", "limits/max_angular", "limits/max_angular_acc"});
  }
  void check(Problems& problems) const;
  /// How far from where the last scan was measured a motion may have to be free [m].
  double reach() const { return robot.limits.max_linear * (simulate_ahead_time + costmap_timeout); }
};

}  // namespace frontier_pilot::behavior
