#pragma once

#include "frontier_pilot/core/time.h"

namespace frontier_pilot {

/// One moment on both clocks.
struct Instant {
  Time ros;
  SteadyTime steady;
};

/// How far ROS time may advance, compared to steady time, without counting as a jump.
struct ClockPace {
  double fastest;  ///< greatest ratio of ROS time to steady time
  double slack;    ///< [s] of ROS time beyond that, for a process that hung and then catches up with the clock at once
};
/// A simulation may run a thousand times as fast as the steady clock.
constexpr ClockPace kSimulatedPace{1000.0, 10000.0};
/// Without a simulation ROS time is the system time, which may be slewed a little, or set.
constexpr ClockPace kRealPace{1.1, 5.0};

/// What ROS time did since the last observation.
enum class ClockEvent {
  kRunning,        ///< it advanced, or has stood still for less than the stall time
  kStopped,        ///< it has stood still for the stall time: ages cannot be computed from it
  kJumpedBack,     ///< it went backward
  kJumpedForward,  ///< it advanced farther than its ClockPace allows
};

/// Checks ROS time against the steady clock. [ARB-9]
class ClockWatch {
 public:
  explicit ClockWatch(Duration stall_time, const ClockPace& pace = kSimulatedPace)
      : stall_time_(stall_time), pace_(pace), credit_(pace.slack) {}

  /// To be called with every input, with steady time that never decreases.
  ClockEvent observe(const Instant& now);
  bool stopped() const { return stopped_; }
  /// The change of ROS time in the last jump [s]; negative: backward.
  double lastJump() const { return last_jump_; }

 private:
  bool jumps(const Instant& now);

  Duration stall_time_;
  ClockPace pace_;
  double credit_;  ///< how much ROS time may still advance beyond its pace [s]
  double last_jump_ = 0.0;
  bool started_ = false;
  bool stopped_ = false;
  SteadyTime last_look_;
  Instant last_moved_;  ///< when ROS time was last seen to change
};

}  // namespace frontier_pilot
