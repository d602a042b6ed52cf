#pragma once

#include <string>

namespace frontier_pilot::bench {

/// The path of the Willow Garage floor's YAML: in $FRONTIER_PILOT_WORLDS, or in ../shared/worlds beside the repository.
std::string willowGarage();

/// That path, or if the file is absent that of the office in config/worlds.
std::string willowGarageOrOffice();

}  // namespace frontier_pilot::bench
