#pragma once

#include "exploration/observed_map.h"
#include "exploration/travel/travel_field.h"
#include "frontier_pilot/core/geometry.h"

namespace frontier_pilot::exploration {

/// Where to send a robot on its way to `goal`, so that it stays within the bounds of `map` although the navigation does
/// not know them. That is the goal itself, or else the last place on the shortest path of `travel` up to which the
/// navigation has no reason to leave the bounds: a straight lane of `half_width` [m] on either side is free, or nothing
/// around the path is out of bounds. If the path does not begin at the robot, or the goal is not reached, the goal is
/// returned. Positions in the map's frame [m]. [EXP-10]
Vec2 stopOnTheWay(const TravelField& travel, const ObservedMap& map, const Vec2& robot, const Vec2& goal,
                  double half_width);

}  // namespace frontier_pilot::exploration
