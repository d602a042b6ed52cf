#pragma once

#include "frontier_pilot/core/time.h"

namespace frontier_pilot {

/// One moment on both clocks.
struct Instant {
  Time ros;
  SteadyTime steady;
};

/// What the ROS clock did since the last look.
enum class ClockEvent {
  kRunning,     ///< it moved on, or rests for less than the stall time
  kStopped,     ///< it has stood still for the stall time: what it says of ages is worthless
  kJumpedBack,  ///< it went backward
};

/// Watches ROS time by the steady clock. [ARB-9]
class ClockWatch {
 public:
  explicit ClockWatch(Duration stall_time) : stall_time_(stall_time) {}

  /// To be called with every input, in the order of steady time.
  ClockEvent observe(const Instant& now);
  bool stopped() const { return stopped_; }

 private:
  Duration stall_time_;
  bool started_ = false;
  bool stopped_ = false;
  Instant last_moved_;  ///< when ROS time was last seen to change
};

}  // namespace frontier_pilot
