#pragma once

#include <stdexcept>
#include <string>

#include "frontier_pilot/core/robot_model.h"

namespace frontier_pilot::bench {

/// The limits that `--limits` names: burger or fast. Throws std::invalid_argument for any other name.
inline RobotLimits limitsNamed(const std::string& name) {
  RobotLimits limits;
  if (name == "burger") return limits;
  if (name != "fast") throw std::invalid_argument("--limits: burger or fast");
  limits.max_linear = 0.5;
  limits.max_angular = 1.5;
  return limits;
}

}  // namespace frontier_pilot::bench
