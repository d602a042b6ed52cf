#include "ros/common/inputs/stop_follower.h"

namespace frontier_pilot {
namespace {

constexpr std::size_t kMostNodes = 20;  // that are told apart
constexpr int kSilence = 100;           // ticks, five seconds, without a status that comes once a second

}  // namespace

void StopFollower::take(bool stopped, int hold_ups) {
  noticeHoldUp(hold_ups);
  by_count_of_.reset();
  clear_waits_ = !stopped && (stopped_ || clear_waits_) && !caught_up_;
  for (auto& [node, counted] : counted_) counted.told |= stopped;
  if (clear_waits_) return;
  if (stopped_ && !stopped) tell_(true);  // for a goal that came while the server's clock was not trusted
  stopped_ = stopped;
  tell_(stopped);
}

/// An arbiter that counts anew, because what it kept is lost, may have been asked for any stop that it has counted; if
/// it has counted as many as the one before it, that is not seen.
void StopFollower::count(const std::string& node, std::uint64_t stops, bool stopped, int hold_ups) {
  noticeHoldUp(hold_ups);
  Counted& last = lastOf(node, stops);
  const bool more = stops > last.stops || (stops < last.stops && stops > 0);
  const bool missed = more && !last.told && !stopped_ && !clear_waits_;
  // A status of before the stop may come after it.
  if (stops != last.stops || (!stopped && !stopped_)) last.told = false;
  last.stops = stops;
  if (missed) {
    stopped_ = true;
    by_count_of_ = node;
    tell_(true);
  }
  if (by_count_of_ != node) return;
  silent_ticks_ = 0;
  if (!stopped) endStopByCount();
}

void StopFollower::endStopByCount() {
  by_count_of_.reset();
  stopped_ = false;
  clear_waits_ = !caught_up_;
  if (caught_up_) tell_(false);
}

StopFollower::Counted& StopFollower::lastOf(const std::string& node, std::uint64_t stops) {
  const auto known = counted_.find(node);
  const auto before = counted_.find(counted_last_);
  const Counted last = known != counted_.end()    ? known->second
                       : before != counted_.end() ? before->second
                                                  : Counted{stops, false};
  if (known == counted_.end() && counted_.size() >= kMostNodes) counted_.clear();
  counted_last_ = node;
  return counted_[node] = last;
}

void StopFollower::tick(const Uris& publishers, int hold_ups, bool catching_up) {
  noticeHoldUp(hold_ups);
  if (catching_up) return;
  caught_up_ = true;
  // Such as a player of a recording in which the robot is stopped at the end.
  if (by_count_of_ && ++silent_ticks_ > kSilence) endStopByCount();
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
