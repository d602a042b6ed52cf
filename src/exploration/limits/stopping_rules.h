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
  /// The rule that is met first in the order area, time, distance, battery; nothing if none is. `battery` is the
  /// charge, 0 to 1; while it is not known, its rule is not met.
  std::optional<ExplorerReason> met(double explored_area, const std::optional<double>& battery) const;
  /// Time and distance are counted from here on, and until/area more than `explored_area` [m^2] is to be explored.
  void startOver(double explored_area);

  double time() const { return toSeconds(time_); }
  double distance() const { return distance_; }

 private:
  UntilParameters until_;
  Duration time_{};
  double distance_ = 0.0;
  double area_before_ = 0.0;  ///< at the beginning of the round [m^2]; 0 in the first one
};

}  // namespace frontier_pilot::exploration
