#pragma once

#include <optional>

#include "frontier_pilot/core/time.h"
#include "frontier_pilot/exploration/explorer_types.h"
#include "frontier_pilot/exploration/parameters.h"

namespace frontier_pilot::exploration {

/// Ends an exploration although frontiers are left. Time and distance are counted in a round, which `startOver` begins
/// anew. [EXP-10]
class StoppingRules {
 public:
  explicit StoppingRules(const UntilParameters& until) : until_(until) {}

  /// To be called for every tick in which the robot explores.
  void count(Duration passed, double driven) {
    time_ += passed;
    distance_ += driven;
  }
  /// What the rules look at besides time and distance.
  struct State {
    double explored_area = 0.0;     ///< [m^2]
    std::optional<double> share;    ///< explored of the whole; while it is not known, its rule is not met
    bool share_estimated = true;    ///< false: nothing was left to explore, which meets no rule
    std::optional<double> battery;  ///< charge, may be a little above 1; likewise
  };
  /// The rule that is met first in the order area, time, distance, battery, share; nothing if none is.
  std::optional<ExplorerReason> met(const State& state) const;
  /// Time and distance are counted from here on, until/area more than is explored now has to be explored, and a share
  /// that is explored already ends nothing.
  void startOver(const State& state);

  double time() const { return toSeconds(time_); }
  double distance() const { return distance_; }
  /// What was explored when the round began [m^2]; 0 in the first one.
  double areaBefore() const { return area_before_; }

 private:
  UntilParameters until_;
  Duration time_{};
  double distance_ = 0.0;
  double area_before_ = 0.0;  ///< at the beginning of the round [m^2]; 0 in the first one
  bool share_counts_ = true;
};

}  // namespace frontier_pilot::exploration
