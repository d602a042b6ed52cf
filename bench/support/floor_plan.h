#pragma once

#include <string>
#include <vector>

#include "frontier_pilot/core/geometry.h"
#include "frontier_pilot/core/grid.h"

namespace frontier_pilot::bench {

enum class BuildingKind { kApartment, kOffice, kHall, kHospital };
const char* toString(BuildingKind kind);

/// A furnished floor of an invented building, drawn at random.
struct FloorPlan {
  int number = 0;
  BuildingKind kind = BuildingKind::kApartment;
  OccupancyGrid map;            ///< cells of 5 cm, surrounded by unknown ones
  Pose2 start;                  ///< at a corner of a cell, with at least 0.3 m of free floor around it
  std::vector<CellRect> rooms;  ///< without corridors, in cells of the map
};

constexpr int kFloorPlans = 40;

/// Plan `number`, 1 to kFloorPlans; it depends on nothing else, not even on the machine. Ten plans are of each kind.
/// The odd ones are for tuning, the even ones for reporting: both halves hold five of each kind, with like sizes.
/// Throws std::invalid_argument for another number.
FloorPlan floorPlan(int number);

}  // namespace frontier_pilot::bench
