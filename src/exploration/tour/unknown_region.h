#pragma once

#include "frontier_pilot/core/grid.h"

namespace frontier_pilot::exploration {

/// The unknown area [m^2] that is connected over 4-neighbours with the unknown neighbours of a frontier cell, within
/// `radius` [m] of it: small for a pocket behind an object, large where the building goes on.
double unknownAreaBehind(const OccupancyGrid& map, Cell frontier, double radius);

}  // namespace frontier_pilot::exploration
