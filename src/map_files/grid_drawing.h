#pragma once

#include <string>

#include "frontier_pilot/core/grid.h"
#include "frontier_pilot/occupancy/occupancy_map.h"

namespace frontier_pilot::map_files {

/// Enters each known cell of `image`, whose resolution is that of `map`, until its log-odds are clamped; the image is
/// shifted by less than a cell where its cells do not coincide with those of the map. Returns what is wrong with the
/// image, as the end of a sentence, if the map has no room for it; empty if it has.
std::string draw(const OccupancyGrid& image, occupancy::OccupancyMap& map);

}  // namespace frontier_pilot::map_files
