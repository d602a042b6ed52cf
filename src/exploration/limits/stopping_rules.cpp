#include "exploration/limits/stopping_rules.h"

namespace frontier_pilot::exploration {

std::optional<ExplorerReason> StoppingRules::met(double explored_area) const {
  if (until_.area > 0.0 && explored_area - area_before_ >= until_.area) return ExplorerReason::kUntilArea;
  if (until_.time > 0.0 && time() >= until_.time) return ExplorerReason::kUntilTime;
  if (until_.distance > 0.0 && distance_ >= until_.distance) return ExplorerReason::kUntilDistance;
  return std::nullopt;
}

void StoppingRules::startOver(double explored_area) {
  time_ = {};
  distance_ = 0.0;
  area_before_ = explored_area;
}

}  // namespace frontier_pilot::exploration
