#pragma once

#include <optional>

#include "frontier_pilot/core/geometry.h"
#include "frontier_pilot/core/time.h"

namespace frontier_pilot::teleop {

/// Decides what goes out on `cmd_vel_manual`, by the window's signs of life. [GUI-3]
///
/// The window beats with its set-point; a publisher that runs on a thread of its own asks at its rate. A window that
/// has gone quiet gets one zero sent in its name and then silence. After that only zeros go out until the window itself
/// has asked for zero once: a window that thaws never moves the robot with what was asked for before. All on steady
/// time.
class ManualOutput {
 public:
  enum class State {
    kWaiting,  ///< no sign of life yet: silent
    kLive,     ///< the set-point goes out
    kRearm,    ///< the window is back: zeros until it has asked for zero
    kFrozen,   ///< no sign of life for the timeout: silent after one zero
    kOff,      ///< manual is switched off: silent after one zero
    kClosed,   ///< the window is gone: silent for good
  };

  explicit ManualOutput(Duration liveness_timeout) : timeout_(liveness_timeout) {}

  /// A sign of life. A set-point that is not finite counts as zero.
  void beat(const Twist2& set_point, SteadyTime now);
  /// What to publish now, if anything. To be called at the publishing rate.
  std::optional<Twist2> update(bool manual_on, SteadyTime now);
  /// The last words: always a zero. Nothing leaves after it.
  Twist2 close();

  State state() const { return state_; }

 private:
  std::optional<Twist2> silence(State state);

  Duration timeout_;
  State state_ = State::kWaiting;
  std::optional<SteadyTime> last_beat_;
  Twist2 set_point_;
};

const char* toString(ManualOutput::State state);

}  // namespace frontier_pilot::teleop
