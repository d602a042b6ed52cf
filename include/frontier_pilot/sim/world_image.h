#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "frontier_pilot/core/geometry.h"
#include "frontier_pilot/core/grid.h"

namespace frontier_pilot::sim {

/// The true map of a world, in the world's frame, and where robots start in it if its file says so.
struct World {
  OccupancyGrid map;
  std::optional<Pose2> start;
};

/// Loads a world from a map_server YAML (mode trinary) and the image it names, PGM or PNG. An additional key
/// `start: [x, y, yaw]` names a default start pose; other unknown keys are ignored, as map_server does. [SIM-1]
/// Throws std::runtime_error naming the file and everything that is wrong with it; a rotated origin is refused.
World loadWorld(const std::string& yaml_path);

/// Non-zero where a robot and a beam stop: at occupied cells, and at unknown ones unless they are declared free. One
/// cell wider than `map` on each side: the world has an end, for robots and beams alike.
Grid<std::uint8_t> solidCells(const OccupancyGrid& map, bool unknown_is_free);

}  // namespace frontier_pilot::sim
