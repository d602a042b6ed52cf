#include "ros/common/inputs/stop_follower.h"

namespace frontier_pilot {

void StopFollower::take(bool stopped, int hold_ups) {
  noticeHoldUp(hold_ups);
  by_count_ = false;
  clear_waits_ = !stopped && (stopped_ || clear_waits_) && !caught_up_;
  told_ = told_ || stopped;
  if (clear_waits_) return;
  if (stopped_ && !stopped) tell_(true);  // for a goal that came while the server's clock was not trusted
  stopped_ = stopped;
  tell_(stopped);
}

/// An arbiter that counts anew, because what it kept is lost, may have been asked for any stop that it has counted; if
/// it has counted as many as the one before it, that is not seen.
void StopFollower::count(std::uint64_t stops, bool stopped, int hold_ups) {
  noticeHoldUp(hold_ups);
  const bool more = counted_ && (stops > *counted_ || (stops < *counted_ && stops > 0));
  const bool missed = more && !told_ && !stopped_ && !clear_waits_;
  if (stops != counted_ || (!stopped && !stopped_)) told_ = false;  // a status of before the stop may come after it
  counted_ = stops;
  if (missed) {
    stopped_ = by_count_ = true;
    tell_(true);
  }
  if (!by_count_ || stopped) return;
  stopped_ = by_count_ = false;
  clear_waits_ = !caught_up_;
  if (caught_up_) tell_(false);
}

void StopFollower::tick(const Uris& publishers, int hold_ups, bool catching_up) {
  noticeHoldUp(hold_ups);
  if (catching_up) return;
  caught_up_ = true;
  if (!publishers.empty()) publishers_ = publishers;
  if (!clear_waits_) return;
  stopped_ = clear_waits_ = false;
  tell_(true);
  tell_(false);
}

void StopFollower::noticeHoldUp(int hold_ups) {
  if (hold_ups == hold_ups_) return;
  hold_ups_ = hold_ups;
  caught_up_ = false;
  if (stopped_ || publishers_.empty() || any_lives_(publishers_)) return;
  clear_waits_ = true;
  tell_(true);
}

}  // namespace frontier_pilot
