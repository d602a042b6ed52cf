#include "ros/common/hold_up_watch.h"

namespace frontier_pilot {

bool HoldUpWatch::isCatchingUp(SteadyTime now) {
  constexpr Duration kHeldUp = std::chrono::milliseconds(300);
  const Duration silent = looked_ ? now - *looked_ : Duration::zero();
  if (silent > kHeldUp) {
    ++count_;
    if (!since_ || silent >= longest_ - backlog_) since_ = now;
    until_ = now + backlog_;
  }
  looked_ = now;
  if (since_ && (now >= until_ || now - *since_ >= longest_)) since_.reset();
  return since_.has_value();
}

}  // namespace frontier_pilot
