#pragma once

#include <optional>
#include <string>

#include "frontier_pilot/core/geometry.h"
#include "frontier_pilot/core/grid.h"

namespace frontier_pilot::map_files {

/// What a map_server YAML and its picture hold: a map, and where robots start in it if the file says so.
struct MapImage {
  OccupancyGrid map;
  std::optional<Pose2> start;
};

/// Reads a map_server YAML (mode trinary) and the picture it names, PGM or PNG. An additional key `start: [x, y, yaw]`
/// names a default start pose; other unknown keys are ignored, as map_server does. [SIM-1] [MAP-5]
/// Throws std::runtime_error naming the file and everything that is wrong with it; a rotated origin is refused.
MapImage readMapImage(const std::string& yaml_path);

/// The bytes of a PGM in map_server's shades for free, occupied and unknown.
std::string pgmOf(const OccupancyGrid& grid);

}  // namespace frontier_pilot::map_files
