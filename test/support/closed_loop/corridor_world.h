#pragma once

#include "frontier_pilot/sim/simulator.h"

namespace frontier_pilot::test {

/// Two rooms joined by a corridor of 33 m without any feature: on its middle 17 m a scanner with a range of 8 m sees
/// neither end.
sim::World corridorWorld();

}  // namespace frontier_pilot::test
