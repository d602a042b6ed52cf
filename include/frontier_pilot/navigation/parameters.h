#pragma once

#include <array>

#include "frontier_pilot/core/geometry.h"
#include "frontier_pilot/core/parameters.h"
#include "frontier_pilot/core/robot_model.h"
#include "frontier_pilot/planning/clearance_map.h"
#include "frontier_pilot/planning/global_planner.h"

namespace frontier_pilot::navigation {

/// How a path is followed.
struct FollowerParams {
  double scan_margin = 0.014;        ///< clearance of the outline from the scan's points [m]
  double lookahead_time = 1.0;       ///< the pursued point is this far ahead at full speed [s]
  double min_lookahead = 0.2;        ///< [m]
  double turn_in_place_angle = 1.3;  ///< above this bearing of the pursued point the robot turns on the spot [rad]
  double horizon = 1.5;              ///< how far ahead motions are simulated [s]
  double reaction_time = 0.25;       ///< from the next scan, if it comes without delay, until the wheels brake [s]
  double command_lifetime = 1.0;     ///< for how long the base follows a command after which no other comes [s]

  template <class Visitor>
  void describe(Visitor& v) {
    v.moved("inscribed_radius", "robot/disc_radius");
    v.field("scan_margin", scan_margin, "m", "clearance of the robot's outline from the scan's points",
            between(0.0, 0.5));
    v.field("command_lifetime", command_lifetime, "s",
            "for how long the base follows the last command of a navigator that has fallen silent, which is the "
            "arbiter's timeout of the source nav: no motion is commanded that would touch something meanwhile",
            between(0.0, 10.0));
    v.fixed({"lookahead_time", "min_lookahead", "turn_in_place_angle", "horizon", "reaction_time"});
  }
};

/// Which obstacles missing from the map are marked, and for how long.
struct ObstacleLayerParams {
  double range = 3.0;          ///< range up to which obstacles are marked [m]
  double memory = 30.0;        ///< how long an obstacle that is out of sight is kept [s]
  int map_tolerance = 2;       ///< a hit this near to an occupied cell belongs to the map [cells]
  double seen_through = 0.15;  ///< beams that reach this much farther than an obstacle remove it [m]

  template <class Visitor>
  void describe(Visitor& v) {
    v.field("range", range, "m", "range up to which obstacles missing from the map are marked", scanRange());
    v.field("memory", memory, "s", "time after which an obstacle that is out of sight is forgotten", timeSpan());
    v.fixed({"map_tolerance", "seen_through"});
  }
};

/// When a robot counts as blocked or oscillating.
struct WatchdogParams {
  double progress_distance = 0.1;     ///< [m]
  double progress_timeout = 10.0;     ///< [s]
  double oscillation_distance = 0.5;  ///< [m]
  double oscillation_timeout = 30.0;  ///< [s]

  template <class Visitor>
  void describe(Visitor& v) {
    v.fixed({"progress_distance"});
    v.field("progress_timeout", progress_timeout, "s", "a robot that makes no progress for this long is blocked",
            timeSpan());
    v.fixed({"oscillation_distance"});
    v.field("oscillation_timeout", oscillation_timeout, "s",
            "a robot that stays within the oscillation distance for this long is oscillating", timeSpan());
  }
};

/// The speeds of backing up, as shares of the full one, which are tried in turn: with little room behind a slower robot
/// may still move, because its last command needs less.
constexpr std::array<double, 3> kSpeedsOfRecovery = {1.0, 0.5, 0.25};

/// Motions of the recoveries.
struct RecoveryParams {
  double back_up_distance = 0.2;  ///< [m]
  double back_up_speed = 0.08;    ///< [m/s]
  double spin_angle = 2.0 * kPi;  ///< [rad]
  double spin_rate = 1.0;         ///< [rad/s]
  double time_allowance = 10.0;   ///< for each [s]
  double margin = 0.015;          ///< clearance of the outline from the scan's points [m]

  template <class Visitor>
  void describe(Visitor& v) {
    v.field("back_up_distance", back_up_distance, "m", "distance that a blocked robot backs up", positiveUpTo(10.0));
    v.fixed({"back_up_speed"});
    v.field("spin_angle", spin_angle, "rad", "angle that a blocked robot turns to look around", positiveUpTo(100.0));
    v.fixed({"spin_rate"});
    v.field("time_allowance", time_allowance, "s",
            "a recovery that takes longer is ended; backing out of a place where the robot cannot turn may take this "
            "for each 0.1 m",
            timeSpan());
    v.field("margin", margin, "m", "clearance of the robot's outline from the scan's points while it recovers",
            between(0.0, 0.5));
    v.moved("footprint_radius", "margin, on top of the robot's outline");
  }
};

/// Parameters of the navigator.
struct NavigatorParams {
  RobotModel robot;
  planning::ClearanceParams clearance;
  planning::GlobalPlannerParams planner;
  FollowerParams follower;
  ObstacleLayerParams obstacles;
  WatchdogParams watchdog;
  RecoveryParams recovery;
  double goal_tolerance = 0.12;   ///< [m]
  double yaw_tolerance = 0.1;     ///< [rad]
  double max_age = 0.5;           ///< of pose and scan [s]
  double data_patience = 15.0;    ///< how long a goal waits for missing data [s]
  double blocked_patience = 2.0;  ///< how long the robot waits before a recovery [s]
  double replan_period = 5.0;     ///< how often a better path is looked for [s]
  double map_period = 0.3;        ///< map updates take effect at most this often [s]

  template <class Visitor>
  void describe(Visitor& v) {
    describeRobot(v, robot);
    v.group("clearance", clearance, "room that paths keep");
    v.group("planner", planner, "global planner");
    v.group("follower", follower, "local control");
    v.group("obstacles", obstacles, "obstacles that the map lacks");
    v.group("watchdog", watchdog, "progress and oscillation");
    v.group("recovery", recovery, "recoveries");
    v.field("goal_tolerance", goal_tolerance, "m", "a goal is reached at this distance", positiveUpTo(100.0));
    v.field("yaw_tolerance", yaw_tolerance, "rad",
            "greatest deviation of the yaw at the goal, if its direction matters", positiveUpTo(100.0));
    v.field("max_age", max_age, "s", "greatest age of pose and scan; beyond it the robot stands", dataAge());
    v.field("data_patience", data_patience, "s", "a goal that waits for data longer is aborted", timeSpan());
    v.field("blocked_patience", blocked_patience, "s", "a blocked robot waits this long before a recovery",
            timeSpanOrNone());
    v.field("replan_period", replan_period, "s", "time between two searches for a better path", timeSpan());
    v.fixed({"map_period"});
    v.tunable({"limits/max_linear", "limits/max_linear_acc", "limits/max_angular", "limits/max_angular_acc",
               "clearance/preferred_clearance", "clearance/unknown_is_traversable", "goal_tolerance", "yaw_tolerance"});
  }
};

}  // namespace frontier_pilot::navigation
