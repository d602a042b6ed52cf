#include "frontier_pilot/core/clock_watch.h"

#include <algorithm>

namespace frontier_pilot {

ClockEvent ClockWatch::observe(const Instant& now) {
  const bool jumped = jumps(now);
  last_look_ = now.steady;
  if (!started_ || now.ros != last_moved_.ros) {
    const bool back = now.ros < last_moved_.ros;
    last_moved_ = now;
    started_ = true;
    stopped_ = false;
    if (!jumped) return ClockEvent::kRunning;
    return back ? ClockEvent::kJumpedBack : ClockEvent::kJumpedForward;
  }
  stopped_ = now.steady - last_moved_.steady >= stall_time_;
  return stopped_ ? ClockEvent::kStopped : ClockEvent::kRunning;
}

bool ClockWatch::jumps(const Instant& now) {
  // ROS time is zero before the first /clock message: the step from there to its first value is not a jump.
  if (!started_ || last_moved_.ros == Time{}) return false;
  const double advance = toSeconds(now.ros - last_moved_.ros);
  const double allowed = credit_ + pace_.fastest * toSeconds(now.steady - last_look_);
  if (advance >= 0.0 && advance <= allowed) {
    credit_ = std::min(allowed - advance, pace_.slack);
    return false;
  }
  last_jump_ = advance;
  credit_ = pace_.slack;
  return true;
}

}  // namespace frontier_pilot
