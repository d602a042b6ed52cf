#include "frontier_pilot/mapping/map_schedule.h"

#include <utility>

namespace frontier_pilot::mapping {

bool MapSchedule::note(const occupancy::MapChanges& changes, Time now) {
  grown_ = grown_ || changes.geometry_changed;
  if (grown_ || changes.cells.empty()) return false;
  last_change_ = now;
  changed_ += static_cast<std::size_t>(changes.cells.width) * static_cast<std::size_t>(changes.cells.height);
  return true;
}

bool MapSchedule::isDue(std::size_t cells, Time now) const {
  constexpr std::size_t kFew = 8;
  constexpr double kPatience = 12.0;
  // A clock that was set back must not delay the map.
  if (!last_ || now < *last_) return true;
  const double waited = toSeconds(now - *last_);
  if (waited < parameters_.min_period) return false;
  if (grown_) return true;
  if (changed_ == 0) return false;
  if (changed_ >= cells || newcomer_) return true;
  if (waited < parameters_.max_period) return false;
  const bool over = toSeconds(now - last_change_) >= parameters_.max_period;
  return over || changed_ >= cells / kFew || waited >= kPatience * parameters_.max_period;
}

bool MapSchedule::sent(Time now) {
  last_ = now;
  changed_ = 0;
  newcomer_ = false;
  return std::exchange(grown_, false);
}

}  // namespace frontier_pilot::mapping
