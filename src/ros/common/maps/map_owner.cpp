#include "ros/common/maps/map_owner.h"

#include <chrono>

namespace frontier_pilot {

void MapOwner::hear(const std::string& node, SteadyTime now) {
  name_ = node;
  heard_ = now;
  dead_ = false;
}

bool MapOwner::lives(SteadyTime now, const Question& question) {
  constexpr Duration kSilence = std::chrono::seconds(5);
  const SteadyTime silent_since = heard_ + kSilence;
  if (dead_ || now < silent_since) return !dead_;
  const std::optional<bool> found = question(name_, silent_since);
  if (found.value_or(false)) heard_ = now;
  dead_ = found == std::optional<bool>(false);
  return !dead_;
}

}  // namespace frontier_pilot
