#pragma once

#include "frontier_pilot/core/grid.h"
#include "frontier_pilot/occupancy/occupancy_map.h"

namespace frontier_pilot::map_files {

/// Enters each known cell of `image`, whose resolution is that of `map`, until its log-odds are clamped; the image is
/// shifted by less than a cell where its cells do not coincide with those of the map. False when the map would get too
/// large.
bool draw(const OccupancyGrid& image, occupancy::OccupancyMap& map);

}  // namespace frontier_pilot::map_files
