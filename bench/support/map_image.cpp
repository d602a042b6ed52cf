#include "map_image.h"

#include <cstdlib>
#include <fstream>
#include <stdexcept>
#include <variant>

#include "frontier_pilot/core/parameters.h"

namespace frontier_pilot::bench {
namespace {

double number(const ParameterMap& map, const std::string& key) {
  const auto& value = map.at(key).value;
  if (const auto* integer = std::get_if<std::int64_t>(&value)) return static_cast<double>(*integer);
  return std::get<double>(value);
}

/// The next number of a PGM's header, past its comments.
int headerNumber(std::istream& file) {
  while ((file >> std::ws).peek() == '#') file.ignore(4096, '\n');
  int value = 0;
  file >> value;
  return value;
}

}  // namespace

OccupancyGrid readMapImage(const std::string& yaml_path) {
  const ParameterMap yaml = loadYamlFile(yaml_path);
  const std::string folder = yaml_path.substr(0, yaml_path.find_last_of('/') + 1);
  std::ifstream file(folder + std::get<std::string>(yaml.at("image").value), std::ios::binary);
  std::string magic;
  file >> magic;
  GridGeometry geometry;
  geometry.width = headerNumber(file);
  geometry.height = headerNumber(file);
  geometry.resolution = number(yaml, "resolution");
  const double top = headerNumber(file);
  file.get();
  if (!file || magic != "P5") throw std::runtime_error(yaml_path + ": its image is not a binary PGM");
  OccupancyGrid map(geometry, kUnknown);
  for (int y = geometry.height - 1; y >= 0; --y) {
    for (int x = 0; x < geometry.width; ++x) {
      const double shade = 1.0 - file.get() / top;
      if (shade > number(yaml, "occupied_thresh")) map[Cell{x, y}] = kOccupied;
      if (shade < number(yaml, "free_thresh")) map[Cell{x, y}] = kFree;
    }
  }
  return map;
}

std::string willowGarage() {
  const char* folder = std::getenv("FRONTIER_PILOT_WORLDS");
  return std::string(folder != nullptr ? folder : "../shared/worlds") + "/willow_garage.yaml";
}

}  // namespace frontier_pilot::bench
