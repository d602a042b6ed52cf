#include "frontier_pilot/core/tick_schedule.h"

namespace frontier_pilot {

bool TickSchedule::isDue(Time now) {
  if (!next_ || now < *next_ - period_) next_ = now + period_;
  if (now < *next_) return false;
  *next_ += period_;
  if (*next_ + period_ < now) next_ = now;
  return true;
}

}  // namespace frontier_pilot
