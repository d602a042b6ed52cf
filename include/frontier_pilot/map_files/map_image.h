#pragma once

#include <optional>
#include <string>

#include "frontier_pilot/core/geometry.h"
#include "frontier_pilot/core/grid.h"
#include "frontier_pilot/occupancy/occupancy_map.h"

namespace frontier_pilot::map_files {

/// The content of a map_server YAML and its image: a map, and the robots' default start pose if the YAML has one.
struct MapImage {
  OccupancyGrid map;
  std::optional<Pose2> start;
};

/// Reads a map_server YAML and the image it names, or the one at `image_path`, PGM or PNG. In the modes scale and raw a
/// cell is occupied from 65 % on, free up to 25 %, and else unknown. An additional key `start: [x, y, yaw]` [m, m, rad]
/// sets a default start pose; other unknown keys are ignored, as by map_server. [SIM-1] [MAP-5] Throws
/// std::runtime_error naming the file and everything that is wrong with it; a rotated origin is refused.
MapImage readMapImage(const std::string& yaml_path, const std::string& image_path = {});

/// The bytes of a PGM image with map_server's grey values for free, occupied and unknown cells.
std::string pgmOf(const OccupancyGrid& grid);
/// The same of a whole map. The image is the only thing as large as the box around the map that it needs.
std::string pgmOf(const occupancy::OccupancyMap& map);

}  // namespace frontier_pilot::map_files
