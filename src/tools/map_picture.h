#pragma once

#include <string>
#include <utility>
#include <vector>

#include "frontier_pilot/core/grid.h"

namespace frontier_pilot::tools {

/// A line through a map, in the map's frame [m].
using Polyline = std::vector<Vec2>;

/// What is drawn over a map.
struct MapPicture {
  Polyline odometry;                            ///< red
  Polyline trajectory;                          ///< blue
  std::vector<std::pair<Vec2, Vec2>> closures;  ///< green
};

/// Writes `map` as a PNG: walls black, floor white, unknown grey. One pixel per cell, or fewer if the map is very
/// large; tracks that leave the map enlarge the picture. False when it cannot be written.
bool writePicture(const OccupancyGrid& map, const MapPicture& picture, const std::string& path);

}  // namespace frontier_pilot::tools
