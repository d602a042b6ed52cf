#include "ros/common/inputs/earlier_stops.h"

namespace frontier_pilot {

void EarlierStops::ask(std::uint64_t known, Duration patience, SteadyTime now) {
  known_ = known;
  patience_ = patience;
  asked_ = now;
}

std::optional<bool> EarlierStops::take(std::uint64_t stops) {
  if (!asks() || !hears_) return std::nullopt;
  dismiss();
  return stops != known_;
}

}  // namespace frontier_pilot
