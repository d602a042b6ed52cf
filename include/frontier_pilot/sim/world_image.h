#pragma once

#include <cstdint>
#include <string>

#include "frontier_pilot/core/grid.h"
#include "frontier_pilot/map_files/map_image.h"

namespace frontier_pilot::sim {

/// The true map of a world, in the world's frame, and where robots start in it if its file says so.
using World = map_files::MapImage;

/// Loads a world as map_files::readMapImage does, with "world" before what it throws. [SIM-1]
World loadWorld(const std::string& yaml_path);

/// Non-zero where a robot and a beam stop: at occupied cells, and at unknown ones unless they are declared free. One
/// cell wider than `map` on each side: the world has an end, for robots and beams alike.
Grid<std::uint8_t> solidCells(const OccupancyGrid& map, bool unknown_is_free);

}  // namespace frontier_pilot::sim
