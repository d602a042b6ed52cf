#include "buildings.h"

#include <cstdlib>
#include <filesystem>

namespace frontier_pilot::bench {

std::string willowGarage() {
  const char* folder = std::getenv("FRONTIER_PILOT_WORLDS");
  return std::string(folder != nullptr ? folder : FRONTIER_PILOT_SOURCE_DIR "/../shared/worlds") +
         "/willow_garage.yaml";
}

std::string willowGarageOrOffice() {
  const std::string willow = willowGarage();
  return std::filesystem::exists(willow) ? willow : FRONTIER_PILOT_SOURCE_DIR "/config/worlds/office.yaml";
}

}  // namespace frontier_pilot::bench
