#pragma once

#include <optional>

#include "exploration/observed_map.h"
#include "exploration/travel/travel_field.h"
#include "frontier_pilot/core/geometry.h"

namespace frontier_pilot::exploration {

/// The room that a robot needs on either side of a straight way [m].
struct LaneWidth {
  double wanted = 0.0;  ///< with the margin that paths to goals leave
  double least = 0.0;   ///< half the robot's width
};

/// Where to send a robot on its way to `goal`, so that it stays within the bounds of `map` although the navigation does
/// not know them. That is the goal itself, or else the last place on the shortest path of `travel` up to which the
/// navigation has no reason to leave the bounds: a straight lane is free, or no way through something out of bounds is
/// as short as the path. A lane of the wanted width is preferred to a narrower one. The path ends at `end`, a reached
/// cell near the goal. If there is none, or the path does not begin at the robot, the goal is returned. Positions in
/// the map's frame [m]. [EXP-10]
Vec2 stopOnTheWay(const TravelField& travel, const ObservedMap& map, const Vec2& robot, const Vec2& goal,
                  const std::optional<Cell>& end, const LaneWidth& lane);

}  // namespace frontier_pilot::exploration
