#pragma once

#include <string>

#include "frontier_pilot/sim/simulator.h"

namespace frontier_pilot::bench {

/// A world to map: `willow`, `corridor` (two rooms joined by 33 m without any feature), `open-place` (80 m wide, with a
/// few trees), `campus` (600 m x 600 m, see campus.h), or a map_server YAML. Throws std::runtime_error as
/// sim::loadWorld does.
sim::World slamWorld(const std::string& name);

}  // namespace frontier_pilot::bench
