#pragma once

#include <cmath>
#include <sstream>
#include <stdexcept>
#include <string>

#include "frontier_pilot/core/bounds.h"
#include "frontier_pilot/map_files/map_io.h"
#include "frontier_pilot/sim/simulator.h"
#include "fuzz/fuzz.h"

namespace frontier_pilot::fuzz {

inline void checkWorld(const sim::World& world) {
  const OccupancyGrid& map = world.map;
  require(map.width() > 0 && map.height() > 0, "a world that is accepted has cells");
  require(map.size() <= bounds::kMostPixels, "a world has at most 64000000 cells");
  require(std::max(map.width(), map.height()) * map.resolution() <= bounds::kMostWorldSide,
          "a world is at most 5 km long");
  require(map.geometry().origin.cwiseAbs().maxCoeff() <= bounds::kMostWorldOrigin, "its origin is near");
  for (const std::int8_t cell : map.cells())
    require(cell == kFree || cell == kOccupied || cell == kUnknown, "a cell is free, occupied or unknown");
  if (world.start) require(world.start->isFinite(), "the start is finite");
}

inline std::string octreeOf(const occupancy::OccupancyMap& map) {
  std::ostringstream out;
  require(map.write(out), "a map can be written");
  return out.str();
}

/// Loads the same files as a map, in place of one with a single cell.
inline void checkMap(const std::string& yaml) {
  occupancy::OccupancyMapParameters parameters;
  parameters.max_memory = 1.0;
  occupancy::OccupancyMap map(parameters);
  map.reserve({-1.0, -1.0}, {1.0, 1.0});
  map.beginScan();
  map.hit({25, 25});
  const std::string before = octreeOf(map);
  const map_files::MapIoResult result = map_files::loadMap(yaml, map);
  require(!result.text.empty(), "the result of loading has a text");
  if (result.ok()) return require(!map.isBlank(), "a map that was loaded is not empty");
  require(octreeOf(map) == before, "a refusal changes nothing");
}

/// Reads a YAML and the image that it names, as a world and as a map.
inline void readWorld(const std::string& yaml) {
  try {
    checkWorld(sim::loadWorld(yaml));
  } catch (const std::runtime_error& error) {
    require(*error.what() != '\0', "a refusal has a reason");
  }
  checkMap(yaml);
}

}  // namespace frontier_pilot::fuzz
