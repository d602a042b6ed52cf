#pragma once

#include <optional>

#include "frontier_pilot/core/time.h"

namespace frontier_pilot {

/// Notices that a process was held up: frozen by a signal or a debugger, or starved by its computer. The messages of
/// that time still wait then, a stop among them perhaps, so that a node that drives reads them before it acts. [FLT-2]
class HoldUpWatch {
 public:
  /// `backlog` is how long reading takes; shorter hold-ups that follow each other delay acting by no more than
  /// `longest`.
  HoldUpWatch(Duration backlog, Duration longest) : backlog_(backlog), longest_(longest) {}

  /// Whether to read first. To be called at least every 0.3 s of a process that is not held up.
  bool isCatchingUp(SteadyTime now);
  /// Number of hold-ups so far.
  int count() const { return count_; }

 private:
  Duration backlog_, longest_;
  std::optional<SteadyTime> looked_;  ///< the last call
  std::optional<SteadyTime> since_;   ///< the first of several short hold-ups, or the last long one
  SteadyTime until_;
  int count_ = 0;
};

}  // namespace frontier_pilot
