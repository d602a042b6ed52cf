#pragma once

#include "frontier_pilot/core/parameters.h"
#include "frontier_pilot/core/robot_model.h"

namespace frontier_pilot::teleop {

/// How the operator's window drives.
struct TeleopParameters {
  RobotModel robot;  ///< the set-point stays within its limits
  double linear_step = 0.05;
  double angular_step = 0.2;
  bool hold_to_run = false;
  double hold_linear = 0.15;
  double hold_angular = 0.8;
  double publish_rate = 10.0;
  double liveness_timeout = 0.4;
  double patrol_side = 1.0;
  int patrol_laps = 1;
  std::string palette = "system";

  template <class Visitor>
  void describe(Visitor& v) {
    describeRobot(v, robot);
    v.field("linear_step", linear_step, "m/s", "what one press of Go or Back adds", baseSpeed());
    v.field("angular_step", angular_step, "rad/s", "what one press of Left or Right adds", baseTurnRate());
    v.field("hold_to_run", hold_to_run, "", "start in the mode in which the robot moves only while a key is pressed");
    v.field("hold_linear", hold_linear, "m/s", "speed while Go or Back is held", baseSpeed());
    v.field("hold_angular", hold_angular, "rad/s", "rate of turn while Left or Right is held", baseTurnRate());
    v.field("publish_rate", publish_rate, "Hz", "messages on cmd_vel_manual per second", Bounds{1.0, 100.0, false});
    v.field("liveness_timeout", liveness_timeout, "s",
            "a window without a sign of life for this long counts as frozen: the robot is stopped",
            Bounds{0.1, 0.8, false});
    v.field("patrol_side", patrol_side, "m", "side or radius that the patrol card starts with",
            Bounds{0.0, 100.0, true});
    v.field("patrol_laps", patrol_laps, "", "laps that the patrol card starts with", between(1, 1000));
    v.field("palette", palette, "", "colours of the window: system, light or dark");
  }
  /// The palette is one of three words.
  void check(Problems& problems) const;
};

}  // namespace frontier_pilot::teleop
