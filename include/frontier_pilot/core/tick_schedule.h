#pragma once

#include <optional>

#include "frontier_pilot/core/time.h"

namespace frontier_pilot {

/// When a periodic tick is due by a clock that may stand still, run fast or jump.
class TickSchedule {
 public:
  explicit TickSchedule(Duration period) : period_(period) {}

  /// Whether a tick is due at `now`; true once for each tick. Ticks that were missed by more than a period are skipped.
  /// A clock that jumps back starts a new period.
  bool isDue(Time now);
  /// What is left until the next tick; zero if it is due, or not known yet.
  Duration left(Time now) const;

 private:
  Duration period_;
  std::optional<Time> next_;
};

}  // namespace frontier_pilot
