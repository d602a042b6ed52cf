// What an explorer does when the clock jumps.
#include "exploration/explorer_impl.h"

namespace frontier_pilot::exploration {

void Explorer::Impl::heedClock(Time now) {
  if (!last_update_) return;
  const Duration passed = now - *last_update_;
  if (passed < Duration::zero()) {
    forgetTime(now);
  } else if (passed >= kLongestTick) {
    skipTime(passed);
  }
}

/// Times measured before the clock jumped back cannot be compared with those after it. What is under way starts over
/// from IDLE; an exploration that is done stays so, because starting over it would drive to its start once more.
void Explorer::Impl::forgetTime(Time now) {
  last_report_.reset();
  nothing_left_since_.reset();
  return_waits_since_.reset();
  state_since_ = last_check_ = last_decision_ = claims_at_ = now;
  if (status_.state == ExplorerState::kDone) return;
  cancelGoal();
  enter(ExplorerState::kIdle, ExplorerReason::kClockJumpedBack, "", now);
}

/// What waits for a time to pass goes on waiting: the clock jumped ahead, or the process was held up. [EXP-5]
void Explorer::Impl::skipTime(Duration gap) {
  if (patience_) patience_->skip(gap);
  if (nothing_left_since_) *nothing_left_since_ += gap;
  if (return_waits_since_) *return_waits_since_ += gap;
  state_since_ += gap;
}

}  // namespace frontier_pilot::exploration
