#pragma once

#include "frontier_pilot/planning/clearance_map.h"

namespace frontier_pilot::test {

/// Parameters for a robot so small that it may stand on every free cell, with no cost for being near a wall.
inline planning::ClearanceParams pointRobot() {
  planning::ClearanceParams params;
  params.inscribed_radius = 0.004;
  params.preferred_clearance = 0.0;
  params.wall_weight = 0.0;
  params.tight_weight = 0.0;
  return params;
}

inline planning::ClearanceMap clearanceOf(const OccupancyGrid& map, const planning::ClearanceParams& params = {}) {
  planning::ClearanceMap clearance(params);
  clearance.setMap(map, map.geometry().rect());
  return clearance;
}

}  // namespace frontier_pilot::test
