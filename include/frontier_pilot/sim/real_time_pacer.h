#pragma once

#include <cstdint>

#include "frontier_pilot/core/time.h"

namespace frontier_pilot::sim {

/// How many steps a simulation owes real time. What it cannot keep up with is forgiven, so that it never races to
/// catch up. [SIM-4]
class RealTimePacer {
 public:
  /// `speed` is simulated over real time, 0 for as fast as it can. `step` is simulated time.
  RealTimePacer(double speed, Duration step) : speed_(speed), step_(step) {}

  /// Steps that are due now.
  std::int64_t due(SteadyTime now);
  /// One of them was made.
  void stepped() { ++made_; }
  /// Nothing is owed for the time until the next call of `due`.
  void rest() { resting_ = true; }
  /// How often backlog was forgiven.
  std::int64_t timesBehind() const { return times_behind_; }

 private:
  double speed_;
  Duration step_;
  bool resting_ = true;
  SteadyTime since_;
  std::int64_t made_ = 0;  ///< since `since_`
  std::int64_t times_behind_ = 0;
};

}  // namespace frontier_pilot::sim
