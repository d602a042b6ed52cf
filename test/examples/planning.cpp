#include "examples.h"

#include "frontier_pilot/planning/global_planner.h"
#include "room.h"

namespace fp = frontier_pilot;

bool examples::planning() {
  //! [example]
  fp::OccupancyGrid map = roomMap();
  for (int y = 0; y < 60; ++y) map[fp::Cell{64, y}] = fp::kOccupied;  // a wall that leaves 1.2 m of the room open
  fp::planning::ClearanceMap clearance;
  clearance.setMap(map, map.geometry().rect());
  clearance.refresh();
  const fp::planning::PlanRequest request{{-2.0, -1.0}, {2.0, -1.0}};
  const fp::planning::PlanResult result = fp::planning::GlobalPlanner().plan(clearance, request);
  return result.found() && result.path.length() > 5.0;  // around the wall; else `result.status` says why not
  //! [example]
}
