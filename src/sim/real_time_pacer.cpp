#include "frontier_pilot/sim/real_time_pacer.h"

#include <limits>

namespace frontier_pilot::sim {
namespace {

constexpr Duration kForgiven = std::chrono::milliseconds(250);  // the largest backlog that is caught up, in real time
constexpr Duration kHeldUp = std::chrono::milliseconds(30);     // between two calls, in real time
constexpr Duration kReading = std::chrono::milliseconds(20);    // in which the network's thread reads what has come

}  // namespace

std::int64_t RealTimePacer::due(SteadyTime now) {
  const bool owed_before = !resting_ && asked_ >= goes_on_;
  if (owed_before && now - asked_ > kHeldUp) goes_on_ = now + kReading;
  asked_ = now;
  if (now < goes_on_) return 0;
  if (speed_ <= 0.0) {
    resting_ = false;
    return std::numeric_limits<std::int64_t>::max();
  }
  const double steps_per_second = speed_ / toSeconds(step_);
  if (!resting_) {
    const auto owed = static_cast<std::int64_t>(toSeconds(now - since_) * steps_per_second) - made_;
    if (static_cast<double>(owed) <= toSeconds(kForgiven) * steps_per_second + 1.0) return owed;
    ++times_behind_;
  }
  resting_ = false;
  since_ = now;
  made_ = 0;
  return 0;
}

}  // namespace frontier_pilot::sim
