#include "frontier_pilot/core/tick_schedule.h"

#include <algorithm>

namespace frontier_pilot {

bool TickSchedule::isDue(Time now) {
  if (!next_ || now < *next_ - period_) next_ = now + period_;
  if (now < *next_) return false;
  *next_ += period_;
  if (*next_ + period_ < now) next_ = now;
  return true;
}

Duration TickSchedule::left(Time now) const {
  return next_ ? std::max(Duration::zero(), *next_ - now) : Duration::zero();
}

}  // namespace frontier_pilot
