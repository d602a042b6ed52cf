#include "map_files/map_yaml.h"

#include <cstdint>
#include <iomanip>
#include <limits>
#include <sstream>
#include <stdexcept>

#include "frontier_pilot/core/files.h"
#include "frontier_pilot/core/parameters.h"

namespace frontier_pilot::map_files {
namespace {

// map_server's trinary format: the darker a pixel, the more likely it is occupied.
constexpr double kOccupiedThreshold = 0.65;
constexpr double kFreeThreshold = 0.196;

std::string hex(std::uint32_t number) {
  std::ostringstream text;
  text << std::hex << std::setw(8) << std::setfill('0') << number;
  return text.str();
}

template <class T>
const T* find(const ParameterMap& map, const char* key) {
  const auto entry = map.find(key);
  return entry == map.end() ? nullptr : std::get_if<T>(&entry->second.value);
}

/// Whether length and checksum under these keys are those of `octree`.
bool names(const ParameterMap& entry, const char* bytes_key, const char* crc_key, const std::string& octree) {
  const auto* bytes = find<std::int64_t>(entry, bytes_key);
  const auto* crc = find<std::string>(entry, crc_key);
  return bytes != nullptr && crc != nullptr && *bytes == static_cast<std::int64_t>(octree.size()) &&
         *crc == hex(crc32(octree));
}

}  // namespace

std::string mapYaml(const GridGeometry& geometry, const std::string& name, const std::string& octree,
                    const std::optional<std::string>& previous) {
  std::ostringstream yaml;
  yaml << std::setprecision(std::numeric_limits<double>::digits10);
  yaml << "image: " << yamlText(name + ".pgm") << "\nresolution: " << geometry.resolution << "\norigin: ["
       << geometry.origin.x() << ", " << geometry.origin.y()
       << ", 0.0]\nnegate: 0\noccupied_thresh: " << kOccupiedThreshold << "\nfree_thresh: " << kFreeThreshold
       << "\noctree:\n  file: " << yamlText(name + ".bt") << "\n  bytes: " << octree.size() << "\n  crc32: \""
       << hex(crc32(octree)) << "\"\n";
  if (previous) {
    yaml << "  previous_bytes: " << previous->size() << "\n  previous_crc32: \"" << hex(crc32(*previous)) << "\"\n";
  }
  return yaml.str();
}

OctreeMatch compareOctree(const std::string& yaml, const std::string& octree) {
  const ParameterMap map = parseYaml(yaml);
  if (map.count("octree") == 0) return OctreeMatch::kNotMentioned;
  const auto* entry = find<ParameterMap>(map, "octree");
  if (entry == nullptr) return OctreeMatch::kAnother;
  if (names(*entry, "bytes", "crc32", octree)) return OctreeMatch::kSame;
  return names(*entry, "previous_bytes", "previous_crc32", octree) ? OctreeMatch::kPrevious : OctreeMatch::kAnother;
}

bool readsAs(const std::string& yaml, const std::string& name, const std::string& octree) {
  try {
    const ParameterMap map = parseYaml(yaml);
    const auto* image = find<std::string>(map, "image");
    const auto* entry = find<ParameterMap>(map, "octree");
    const auto* file = entry != nullptr ? find<std::string>(*entry, "file") : nullptr;
    return image != nullptr && *image == name + ".pgm" && file != nullptr && *file == name + ".bt" &&
           compareOctree(yaml, octree) == OctreeMatch::kSame;
  } catch (const std::invalid_argument&) {
    return false;
  }
}

}  // namespace frontier_pilot::map_files
