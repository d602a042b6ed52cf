#pragma once

#include "frontier_pilot/core/geometry.h"
#include "frontier_pilot/core/parameters.h"
#include "frontier_pilot/core/robot_model.h"

namespace frontier_pilot::avoid {

/// The directions from `from` counter-clockwise to `to`, seen from the base's origin, both included.
struct Sector {
  double from = 0.0;
  double to = 0.0;

  template <class Visitor>
  void describe(Visitor& v) {
    v.field("from", from, "rad", "first direction of the sector, in the base frame", between(-2.0 * kPi, 2.0 * kPi));
    v.field("to", to, "rad", "last direction of the sector, counter-clockwise of the first",
            between(-2.0 * kPi, 2.0 * kPi));
  }
  /// Its angular width [rad], in [0, 2 pi).
  double width() const;
};

/// The parameters of the avoider. A distance of 0 means the default for its robot, see `AvoiderDistances`.
struct AvoiderParameters {
  RobotModel robot;
  Sector front_left{0.0, kPi / 3.0};
  Sector front_right{-kPi / 3.0, 0.0};
  Sector rear{2.0 * kPi / 3.0, -2.0 * kPi / 3.0};
  double stop_distance = 0.0;
  double clear_distance = 0.0;
  double rear_stop_distance = 0.0;
  double guard_margin = 0.025;
  double reverse_speed = 0.08;
  double reverse_time = 0.4;
  double turn_speed = 0.7;
  double turn_time = 0.8;
  int max_cycles = 12;
  double max_scan_age = 0.5;
  double max_invalid_share = 0.9;

  template <class Visitor>
  void describe(Visitor& v) {
    describeRobot(v, robot);
    v.group("front_left", front_left, "the sector ahead on the left");
    v.group("front_right", front_right, "the sector ahead on the right");
    v.group("rear", rear, "the sector behind");
    v.field("stop_distance", stop_distance, "m",
            "an obstacle ahead that is nearer to the base's origin starts a recovery; 0: 0.395 m ahead of the robot's "
            "front, 0.5 m for a Burger",
            scanRangeOrNone());
    v.field("clear_distance", clear_distance, "m",
            "a recovery ends when nothing ahead is nearer to the base's origin; 0: 0.15 m more than stop_distance",
            scanRangeOrNone());
    v.field("rear_stop_distance", rear_stop_distance, "m",
            "no reversing when something behind is nearer to the base's origin; 0: 0.145 m behind the robot's rear, "
            "0.25 m for a Burger",
            scanRangeOrNone());
    v.fixed({"guard_margin"});
    v.fixed({"guard_half_width"});
    v.field("reverse_speed", reverse_speed, "m/s", "speed of reversing", baseSpeed());
    v.field("reverse_time", reverse_time, "s", "duration of reversing in a cycle", Bounds{0.0, 60.0, false});
    v.field("turn_speed", turn_speed, "rad/s", "rate of turning away", baseTurnRate());
    v.field("turn_time", turn_time, "s", "greatest duration of turning in a cycle", Bounds{0.0, 60.0, true});
    v.field("max_cycles", max_cycles, "", "cycles that did not help before it gives up", countFrom(1));
    v.field("max_scan_age", max_scan_age, "s", "an older scan is a fault", dataAge());
    v.field("max_invalid_share", max_invalid_share, "", "greatest share of invalid beams; a scan with more is a fault",
            between(0.0, 1.0));
    v.tunable({"stop_distance", "clear_distance", "rear_stop_distance", "reverse_speed", "turn_speed"});
  }
  /// Sectors must be narrower than half a turn, `stop_distance` beyond the robot's front and `clear_distance` beyond
  /// that.
  void check(Problems& problems) const;
};

/// Distances from the base's origin that have to be free [m]: as configured, or by default from the robot's outline.
/// The default ahead suffices for a base at 0.65 m/s that brakes with 1 m/s^2 and a scanner at 5.5 Hz; that behind
/// suffices for the avoider's own speed of 0.08 m/s.
struct AvoiderDistances {
  explicit AvoiderDistances(const AvoiderParameters& parameters);

  double stop;
  double clear;
  double rear_stop;
  double half_lane;  ///< half the width of the lane that the body sweeps driving straight, with a margin
  double turn;  ///< the radius that its corners sweep in a turn, with a margin; 0 for a disc, which may always turn
};

}  // namespace frontier_pilot::avoid
