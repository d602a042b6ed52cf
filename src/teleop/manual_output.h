#pragma once

#include <optional>

#include "frontier_pilot/core/geometry.h"
#include "frontier_pilot/core/time.h"

namespace frontier_pilot::teleop {

/// Decides what is published on `cmd_vel_manual`, by the heartbeats of the operator's window. [GUI-3]
///
/// The window sends its set-point as a heartbeat; a publisher on a thread of its own calls `update` at its rate. When
/// the heartbeats cease, one zero is published and then nothing. When they resume, only zeros are published until the
/// window itself has asked for zero once: a window that was frozen never moves the robot by an old set-point. All times
/// are steady time.
class ManualOutput {
 public:
  enum class State {
    kWaiting,  ///< no heartbeat yet: silent
    kLive,     ///< the set-point is published
    kRearm,    ///< the window is back: zeros until it has asked for zero
    kFrozen,   ///< no heartbeat for the timeout: silent after one zero
    kOff,      ///< manual is switched off: silent after one zero
    kClosed,   ///< the window is closed: silent from now on
  };

  explicit ManualOutput(Duration liveness_timeout) : timeout_(liveness_timeout) {}

  /// A heartbeat. A set-point that is not finite counts as zero.
  void beat(const Twist2& set_point, SteadyTime now);
  /// What to publish now, if anything. To be called at the publishing rate.
  std::optional<Twist2> update(bool manual_on, SteadyTime now);
  /// The last message to publish, always a zero. `update` returns nothing after it.
  Twist2 close();

  State state() const { return state_; }

 private:
  std::optional<Twist2> silence(State state);

  Duration timeout_;
  State state_ = State::kWaiting;
  std::optional<SteadyTime> last_beat_;
  Twist2 set_point_;
  bool asked_for_zero_ = false;  ///< by the window, since it was silenced
};

const char* toString(ManualOutput::State state);

}  // namespace frontier_pilot::teleop
