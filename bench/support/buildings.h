#pragma once

#include <string>

namespace frontier_pilot::bench {

/// The YAML of the Willow Garage floor: in $FRONTIER_PILOT_WORLDS, or in ../shared/worlds beside the repository.
std::string willowGarage();

/// That one, or where it is absent the office of config/worlds.
std::string willowGarageOrOffice();

}  // namespace frontier_pilot::bench
