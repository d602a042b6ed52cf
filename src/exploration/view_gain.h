#pragma once

#include "frontier_pilot/core/geometry.h"
#include "frontier_pilot/core/grid.h"
#include "frontier_pilot/exploration/frontier.h"
#include "frontier_pilot/exploration/parameters.h"

namespace frontier_pilot::exploration {

/// Expected newly seen area from `from` [m, rad], within the scanner's field of view: every beam goes up to the first
/// occupied cell, the sensor's range, or `unknown_depth` beyond the first unknown cell, and counts the area of its
/// sector from the first unknown cell on. The sectors do not overlap, so nothing is counted twice. [EXP-4]
ViewGain viewGain(const OccupancyGrid& map, const Pose2& from, const ViewParameters& parameters);

/// The plain definition: the unknown share of the cells within `radius` [m] of `from`; `area` is that of the unknown
/// cells. [EXP-4]
ViewGain unknownShare(const OccupancyGrid& map, const Vec2& from, double radius);

/// The occupied share of the known cells within `radius` cells of `centre`; 0 where none is known. [EXP-3]
double obstacleDensity(const OccupancyGrid& map, Cell centre, int radius);

/// Whether every cell on the line between the centres of `from` and `to`, both included, is free.
bool inSight(const OccupancyGrid& map, Cell from, Cell to);

}  // namespace frontier_pilot::exploration
