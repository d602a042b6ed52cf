#pragma once

#include <cstdint>
#include <string>

#include "frontier_pilot/core/grid.h"
#include "frontier_pilot/map_files/map_image.h"

namespace frontier_pilot::sim {

/// The true map of a world, in the world's frame, and the default start pose if its file has one.
using World = map_files::MapImage;

/// Loads a world with map_files::readMapImage, and puts "world" before the text of what that throws. [SIM-1]
World loadWorld(const std::string& yaml_path);

/// Non-zero where robots and beams are stopped: in occupied cells, in unknown ones unless `unknown_is_free`, and in a
/// ring of one cell around `map`, where the world ends.
Grid<std::uint8_t> solidCells(const OccupancyGrid& map, bool unknown_is_free);

}  // namespace frontier_pilot::sim
