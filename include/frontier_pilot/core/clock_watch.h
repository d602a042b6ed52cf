#pragma once

#include "frontier_pilot/core/time.h"

namespace frontier_pilot {

/// One moment on both clocks.
struct Instant {
  Time ros;
  SteadyTime steady;
};

/// How far ROS time may come on while the steady clock does.
struct ClockPace {
  double fastest;  ///< seconds of ROS time in one of steady time
  double slack;    ///< [s] beyond that: what a process that hung has to catch up with
};
/// A simulation may run a thousand times as fast as the steady clock.
constexpr ClockPace kSimulatedPace{1000.0, 10000.0};
/// Without a simulation ROS time is the system's, which is slewed a little, or set.
constexpr ClockPace kRealPace{1.1, 5.0};

/// What the ROS clock did since the last look.
enum class ClockEvent {
  kRunning,        ///< it moved on, or rests for less than the stall time
  kStopped,        ///< it has stood still for the stall time: what it says of ages is worthless
  kJumpedBack,     ///< it went backward
  kJumpedForward,  ///< it went further than its pace explains
};

/// Watches ROS time by the steady clock. [ARB-9]
class ClockWatch {
 public:
  explicit ClockWatch(Duration stall_time, const ClockPace& pace = kSimulatedPace)
      : stall_time_(stall_time), pace_(pace), credit_(pace.slack) {}

  /// To be called with every input, in the order of steady time.
  ClockEvent observe(const Instant& now);
  bool stopped() const { return stopped_; }
  /// By how much the last jump led astray [s].
  double lastJump() const { return last_jump_; }

 private:
  bool jumps(const Instant& now);

  Duration stall_time_;
  ClockPace pace_;
  double credit_;  ///< by how much ROS time may come on, besides its pace [s]
  double last_jump_ = 0.0;
  bool started_ = false;
  bool stopped_ = false;
  SteadyTime last_look_;
  Instant last_moved_;  ///< when ROS time was last seen to change
};

}  // namespace frontier_pilot
