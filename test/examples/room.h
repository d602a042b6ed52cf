#pragma once

#include "frontier_pilot/core/grid.h"
#include "frontier_pilot/core/laser_scan.h"

/// What the examples see and drive in: an empty room of 6 m by 4 m around the origin.
namespace examples {

/// What a scanner at `pose` measures there with 360 beams, the first of which points straight ahead.
frontier_pilot::LaserScan2 scanFrom(const frontier_pilot::Pose2& pose, frontier_pilot::Time stamp = {});

/// The map of the room in cells of 5 cm, with walls of 20 cm around it.
frontier_pilot::OccupancyGrid roomMap();

}  // namespace examples
