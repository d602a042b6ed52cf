#include "frontier_pilot/core/clock_trust.h"

#include <utility>

namespace frontier_pilot {

TrustChange ClockTrust::observe(const Instant& now) {
  const ClockEvent event = watch_.observe(now);
  if (event == ClockEvent::kJumpedBack || event == ClockEvent::kJumpedForward) {
    ++jumps_;
    jumped_ = now.steady;
    if (!std::exchange(trusted_, false)) return TrustChange::kNone;
    jump_ = watch_.lastJump();
    return TrustChange::kLost;
  }
  if (trusted_ || now.steady - jumped_ < settling_time_) return TrustChange::kNone;
  trusted_ = true;
  return TrustChange::kRegained;
}

}  // namespace frontier_pilot
