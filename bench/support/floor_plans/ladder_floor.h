#pragma once

#include "support/floor_plans/building.h"

namespace frontier_pilot::bench {

/// A floor with two long corridors that cross corridors join, so that one can walk in circles.
struct LadderStyle {
  RoomKinds outer;   ///< along the facades
  RoomKinds middle;  ///< between the long corridors
  RoomKinds ends;    ///< at the ends of the building
  int corridor = 0;  ///< width of the long corridors [cells]
  int depth = 0;     ///< of the rooms along the facades [cells]
};

/// Draws one of about `area` [m^2] between its outer walls.
Building ladderFloor(int area, const LadderStyle& style, PlanRandom& random);

}  // namespace frontier_pilot::bench
