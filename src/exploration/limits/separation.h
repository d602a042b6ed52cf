#pragma once

#include "exploration/observed_map.h"
#include "frontier_pilot/core/geometry.h"

namespace frontier_pilot::exploration {

/// Whether the bounds separate the robot from `place`, alone or together with the walls of the map: then every way to
/// it leads through what is out of bounds. False without bounds, and where the walls alone separate the two. What is
/// out of bounds counts as free of walls. Positions in the map's frame [m]. [EXP-10]
bool boundsSeparate(const ObservedMap& map, const Vec2& robot, const Vec2& place);

}  // namespace frontier_pilot::exploration
