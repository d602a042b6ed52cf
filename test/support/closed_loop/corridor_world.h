#pragma once

#include "frontier_pilot/sim/world_image.h"

namespace frontier_pilot::test {

/// Two rooms and a corridor of 33 m without a feature between them: over the middle 17 m a scanner of 8 m sees neither
/// end.
sim::World corridorWorld();

}  // namespace frontier_pilot::test
