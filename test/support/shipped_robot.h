#pragma once

#include <string>

#include "frontier_pilot/core/robot_model.h"

namespace frontier_pilot::test {

/// A robot from config/robots/: burger, waffle, turtlebot2 or fast. Throws std::invalid_argument with what is wrong
/// with its file.
RobotModel shippedRobot(const std::string& name);

}  // namespace frontier_pilot::test
