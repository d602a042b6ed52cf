#pragma once

#include <cstdint>

#include "frontier_pilot/sim/simulator.h"

namespace frontier_pilot::bench {

/// An invented campus of 600 m x 600 m in cells of 0.2 m: 100 plots between streets with lamps and trees. Three in five
/// plots are buildings of rooms along corridors, some of them around a courtyard; the others are groves, car parks and
/// open squares. The world depends only on `seed`, not on the machine.
sim::World campus(std::uint64_t seed = 1);

}  // namespace frontier_pilot::bench
