#include <stdexcept>

#include "frontier_pilot/sim/simulator.h"

namespace frontier_pilot::sim {

World loadWorld(const std::string& yaml_path) {
  try {
    return map_files::readMapImage(yaml_path);
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(std::string("world ") + error.what());
  }
}

}  // namespace frontier_pilot::sim
