#pragma once

#include <string>

#include "frontier_pilot/core/grid.h"

namespace frontier_pilot::bench {

/// Reads a map_server YAML with a binary PGM, at the resolution and thresholds it names. Throws std::runtime_error.
OccupancyGrid readMapImage(const std::string& yaml_path);

/// The Willow Garage floor: $FRONTIER_PILOT_WORLDS or ../shared/worlds beside the repository.
std::string willowGarage();

}  // namespace frontier_pilot::bench
