#pragma once

#include "frontier_pilot/core/geometry.h"
#include "frontier_pilot/core/parameters.h"

namespace frontier_pilot {

/// The directions from `from` counter-clockwise to `to`, seen from the base's centre, both included.
struct Sector {
  double from = 0.0;
  double to = 0.0;

  template <class Visitor>
  void describe(Visitor& v) {
    v.field("from", from, "rad", "first direction, in the base frame", between(-2.0 * kPi, 2.0 * kPi));
    v.field("to", to, "rad", "last direction, counter-clockwise of the first", between(-2.0 * kPi, 2.0 * kPi));
  }
  /// How wide it is [rad], in [0, 2 pi).
  double width() const;
};

/// What the avoider is configured with.
struct AvoiderParameters {
  Sector front_left{0.0, kPi / 3.0};
  Sector front_right{-kPi / 3.0, 0.0};
  Sector rear{2.0 * kPi / 3.0, -2.0 * kPi / 3.0};
  double stop_distance = 0.5;
  double clear_distance = 0.65;
  double rear_stop_distance = 0.25;
  double guard_half_width = 0.13;
  double reverse_speed = 0.08;
  double reverse_time = 0.4;
  double turn_speed = 0.7;
  double turn_time = 0.8;
  int max_cycles = 12;
  double max_scan_age = 0.5;
  double max_invalid_share = 0.9;

  template <class Visitor>
  void describe(Visitor& v) {
    v.group("front_left", front_left, "the sector ahead on the left");
    v.group("front_right", front_right, "the sector ahead on the right");
    v.group("rear", rear, "the sector behind");
    v.field("stop_distance", stop_distance, "m", "an obstacle ahead that is nearer starts a recovery", positive());
    v.field("clear_distance", clear_distance, "m", "a recovery ends when nothing ahead is nearer", positive());
    v.field("rear_stop_distance", rear_stop_distance, "m", "no reversing when something behind is nearer",
            atLeast(0.0));
    v.field("guard_half_width", guard_half_width, "m",
            "half the width of the lane that the body sweeps: what is in it beside the sectors counts too",
            atLeast(0.0));
    v.field("reverse_speed", reverse_speed, "m/s", "speed of reversing", positive());
    v.field("reverse_time", reverse_time, "s", "how long a cycle reverses", Bounds{0.0, 60.0, false});
    v.field("turn_speed", turn_speed, "rad/s", "rate of turning away", positive());
    v.field("turn_time", turn_time, "s", "how long a cycle turns at most", Bounds{0.0, 60.0, true});
    v.field("max_cycles", max_cycles, "", "cycles that did not help before it gives up", atLeast(1.0));
    v.field("max_scan_age", max_scan_age, "s", "an older scan is a fault", Bounds{0.0, 60.0, true});
    v.field("max_invalid_share", max_invalid_share, "", "a scan with more invalid beams is a fault", between(0.0, 1.0));
  }
  /// Sectors must be narrower than half a turn, and `clear_distance` beyond `stop_distance`.
  void check(Problems& problems) const;
};

}  // namespace frontier_pilot
