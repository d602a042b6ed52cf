#pragma once

#include "frontier_pilot/core/parameters.h"
#include "frontier_pilot/core/robot_model.h"

namespace frontier_pilot::patrol {

/// How a patrol is driven. The default speeds are below a Burger's limits, so that its wheels can follow the profile; a
/// slower robot is driven within its own limits.
struct PatrolParameters {
  RobotModel robot;
  double frequency = 20.0;
  double linear_speed = 0.18;
  double linear_acc = 0.4;
  double min_linear_speed = 0.02;
  double turn_speed = 1.0;
  double turn_acc = 1.5;
  double min_turn_speed = 0.08;
  double heading_gain = 2.0;
  double lateral_gain = 2.0;
  double max_side = 10.0;
  int max_laps = 100;
  double odometry_timeout = 0.5;
  double jump_distance = 0.5;
  double jump_angle = 1.5;
  double blocked_timeout = 10.0;
  double settle_timeout = 0.5;
  double simulate_ahead_time = 1.0;
  double obstacle_timeout = 1.0;

  template <class Visitor>
  void describe(Visitor& v) {
    describeRobot(v, robot);
    v.field("frequency", frequency, "Hz", "control cycles per second", between(5.0, 100.0));
    v.field("linear_speed", linear_speed, "m/s", "speed on a line or an arc", baseSpeed());
    v.field("linear_acc", linear_acc, "m/s^2", "acceleration of the trapezoid profile", baseAcceleration());
    v.fixed({"min_linear_speed"});
    v.field("turn_speed", turn_speed, "rad/s", "rate of turn at a corner, and greatest one on an arc", baseTurnRate());
    v.field("turn_acc", turn_acc, "rad/s^2", "acceleration of the trapezoid profile", baseAcceleration());
    v.fixed({"min_turn_speed", "heading_gain", "lateral_gain"});
    v.field("max_side", max_side, "m", "longest side, or radius, that is accepted", positiveUpTo(1000.0));
    v.field("max_laps", max_laps, "", "greatest number of laps that is accepted", between(1, 10000));
    v.field("odometry_timeout", odometry_timeout, "s", "greatest age of odometry", dataAge());
    v.fixed({"jump_distance", "jump_angle"});
    v.field("blocked_timeout", blocked_timeout, "s",
            "time without the wheels, or without progress on a free way, after which a patrol is given up", timeSpan());
    v.fixed({"settle_timeout"});
    v.field(
        "simulate_ahead_time", simulate_ahead_time, "s",
        "how far ahead the way must be free of obstacles, in time at full speed, on top of the way that braking takes",
        positiveUpTo(30.0));
    v.field("obstacle_timeout", obstacle_timeout, "s",
            "how long the robot stands before an obstacle until the patrol is given up", timeSpanOrNone());
    v.tunable({"linear_speed", "linear_acc", "turn_speed", "turn_acc", "limits/max_linear", "limits/max_linear_acc",
               "limits/max_angular", "limits/max_angular_acc"});
  }
  void check(Problems& problems) const {
    if (min_linear_speed > linear_speed)
      problems.push_back("linear_speed: must be at least " + std::to_string(min_linear_speed) + " m/s");
    if (min_turn_speed > turn_speed)
      problems.push_back("turn_speed: must be at least " + std::to_string(min_turn_speed) + " rad/s");
  }
};

/// `parameters` with speeds and accelerations reduced to the robot's limits.
PatrolParameters withinLimits(PatrolParameters parameters);
/// How far ahead of where the robot was `age` [s] ago a patrol looks [m].
double reach(const PatrolParameters& parameters, double age);

}  // namespace frontier_pilot::patrol
