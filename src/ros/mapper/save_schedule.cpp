#include "ros/mapper/save_schedule.h"

#include <chrono>
#include <sstream>

namespace frontier_pilot {
namespace {

// Pauses, in multiples of the time that saving took. One that failed may have waited for a disk that is free again.
constexpr int kRest = 20;
constexpr int kRestAfterFailure = 3;
constexpr Duration kLong = std::chrono::seconds(30);

}  // namespace

bool SaveSchedule::isDue(std::uint64_t content, SteadyTime now) const {
  return !begun_ && content_ != content && now >= next_;
}

void SaveSchedule::begin(std::uint64_t content, SteadyTime now) {
  begun_ = now;
  content_ = content;
}

void SaveSchedule::end(bool saved, SteadyTime at, Duration took) {
  begun_.reset();
  if (!content_) return;  // it was discarded meanwhile
  next_ = at + (saved ? kRest : kRestAfterFailure) * took;
  if (saved) {
    has_copy_ = true;
  } else {
    content_.reset();
  }
}

void SaveSchedule::discard() {
  content_.reset();
  next_ = {};
  has_copy_ = false;
}

std::string SaveSchedule::delay(SteadyTime now) const {
  if (!begun_ || now - *begun_ < kLong) return {};
  std::ostringstream text;
  text << "it has not been kept for " << std::chrono::duration_cast<std::chrono::seconds>(now - *begun_).count()
       << " s: the disk of ROS_HOME does not answer";
  return text.str();
}

}  // namespace frontier_pilot
