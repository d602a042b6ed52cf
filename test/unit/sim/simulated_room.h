#pragma once

#include "frontier_pilot/sim/simulator.h"
#include "support/ascii_world.h"

namespace frontier_pilot::sim {

using test::AsciiWorld;
using test::drawWorld;

// A room of 2 m by 1.5 m at 0.1 m a cell, with a pillar.
inline AsciiWorld room() {
  return drawWorld(R"(
      ####################
      #..................#
      #..................#
      #..................#
      #..................#
      #.............##...#
      #..s..........##...#
      #..................#
      #..................#
      #..................#
      ####################)",
                   0.1);
}

inline SimulatorParameters quiet() {
  SimulatorParameters parameters;
  parameters.x = 0.35;
  parameters.y = 0.45;
  parameters.yaw = 0.0;
  parameters.lidar.noise_stddev = 0.0;
  parameters.robot.scanner.x = 0.0;
  return parameters;
}

inline World world(const AsciiWorld& drawing) { return {drawing.map, std::nullopt}; }

inline void drive(Simulator& simulator, const Twist2& twist, double seconds, std::size_t robot = 0) {
  const Time end = simulator.now() + fromSeconds(seconds);
  while (simulator.now() < end) {
    simulator.setCommand(robot, twist);
    simulator.step();
  }
}

}  // namespace frontier_pilot::sim
