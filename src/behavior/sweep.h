#pragma once

#include "frontier_pilot/behavior/timed_behavior.h"
#include "frontier_pilot/core/grid.h"
#include "frontier_pilot/core/outline.h"

namespace frontier_pilot::behavior {

/// Whether the footprint stays on free cells of `grid` during all of `motion` from `pose`, both ends included; between
/// checked poses its farthest corner moves by at most half a cell. On a line, an obstacle that lies under the trailing
/// half of the footprint at the start does not count, because the robot moves away from it. An obstacle anywhere on the
/// way counts more than unknown ground before it. [SPN-2] [SPN-3]
SweepResult sweep(const OccupancyGrid& grid, const Outline& footprint, const Pose2& pose, AxisMotion motion);

}  // namespace frontier_pilot::behavior
