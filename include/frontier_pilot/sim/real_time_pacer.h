#pragma once

#include <cstdint>

#include "frontier_pilot/core/time.h"

namespace frontier_pilot::sim {

/// Paces a simulation by real time: tells how many steps are due. A backlog of up to 250 ms of real time is caught up;
/// a larger one is dropped. After it has been held up for more than 30 ms it owes nothing for another 20 ms, so that
/// commands which have come meanwhile, a stop among them, are read before the robot makes up for lost time with an
/// older one. [SIM-4]
class RealTimePacer {
 public:
  /// `speed` is simulated time over real time, 0 for as fast as possible. `step` is simulated time.
  RealTimePacer(double speed, Duration step) : speed_(speed), step_(step) {}

  /// Steps that are due now.
  std::int64_t due(SteadyTime now);
  /// To be called after each step of the simulation.
  void stepped() { ++made_; }
  /// The simulation is paused until the next call of `due`.
  void rest() { resting_ = true; }
  /// How often a backlog was dropped.
  std::int64_t timesBehind() const { return times_behind_; }

 private:
  double speed_;
  Duration step_;
  bool resting_ = true;
  SteadyTime asked_;    ///< when `due` was called last
  SteadyTime goes_on_;  ///< when something is owed again after it was held up
  SteadyTime since_;
  std::int64_t made_ = 0;  ///< steps since `since_`
  std::int64_t times_behind_ = 0;
};

}  // namespace frontier_pilot::sim
