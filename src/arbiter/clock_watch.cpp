#include "frontier_pilot/arbiter/clock_watch.h"

namespace frontier_pilot {

ClockEvent ClockWatch::observe(const Instant& now) {
  const bool jumped_back = started_ && now.ros < last_moved_.ros;
  if (!started_ || now.ros != last_moved_.ros) {
    last_moved_ = now;
    started_ = true;
    stopped_ = false;
    return jumped_back ? ClockEvent::kJumpedBack : ClockEvent::kRunning;
  }
  stopped_ = now.steady - last_moved_.steady >= stall_time_;
  return stopped_ ? ClockEvent::kStopped : ClockEvent::kRunning;
}

}  // namespace frontier_pilot
