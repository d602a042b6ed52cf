#pragma once

#include <string>

#include "frontier_pilot/core/robot_model.h"
#include "support/shipped_robot.h"

namespace frontier_pilot::bench {

/// The robot that `--robot` names: one of config/robots/, or with a `/` in it the path of a file like those; the
/// default robot if it is empty. Throws std::invalid_argument with what is wrong with the file.
inline RobotModel robotNamed(const std::string& name) {
  if (name.empty()) return {};
  return name.find('/') == std::string::npos ? test::shippedRobot(name) : loadRobot(name);
}

}  // namespace frontier_pilot::bench
