#pragma once

#include "simulated_room.h"
#include "support/shipped_robot.h"

namespace frontier_pilot::sim {

// A robot that no disc stands for, with its scanner above the wheels and limits that hardly matter.
inline SimulatorParameters waffleAt(double x, double y, double yaw) {
  SimulatorParameters parameters = quiet();
  parameters.robot = test::shippedRobot("waffle");
  parameters.robot.scanner.x = 0.0;
  parameters.x = x;
  parameters.y = y;
  parameters.yaw = yaw;
  return parameters;
}

constexpr double kWaffleFront = 0.077;
constexpr double kWaffleRear = 0.205;
constexpr double kWaffleHalfWidth = 0.153;
inline double waffleRadius() { return std::hypot(kWaffleRear, kWaffleHalfWidth); }

// The yaw at which a Waffle that turns right in place brings its corner behind on the left to `beside` [m] from its
// base's middle line.
inline double yawOfContact(double beside) {
  return kPi - std::asin(beside / waffleRadius()) - std::atan2(kWaffleHalfWidth, -kWaffleRear);
}

}  // namespace frontier_pilot::sim
