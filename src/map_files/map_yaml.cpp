#include "map_files/map_yaml.h"

#include <cstdint>
#include <iomanip>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string_view>

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

const char* keyOf(SavedFile file) { return file == SavedFile::kOctree ? "octree" : "picture"; }

/// The name, without its extension, of the file that an entry is about; empty if there is none.
std::string nameIn(const ParameterMap& map, SavedFile saved, std::string_view extension) {
  const auto* entry = find<ParameterMap>(map, keyOf(saved));
  const auto* file = entry != nullptr ? find<std::string>(*entry, "file") : nullptr;
  const bool ours = file != nullptr && file->size() > extension.size() &&
                    file->compare(file->size() - extension.size(), extension.size(), extension) == 0;
  return ours ? file->substr(0, file->size() - extension.size()) : "";
}

/// The lines with length and checksum of a file under `prefix`.
std::string checksums(const std::string& prefix, const std::string& content) {
  std::ostringstream lines;
  lines << "  " << prefix << "bytes: " << content.size() << "\n  " << prefix << "crc32: \"" << hex(crc32(content))
        << "\"\n";
  return lines.str();
}

std::string entryOf(SavedFile file, const std::string& name, const SavedContent& content) {
  std::string entry = std::string(keyOf(file)) + ":\n  file: " + yamlText(name) + "\n" + checksums("", content.now);
  return content.previous ? entry + checksums("previous_", *content.previous) : entry;
}

}  // namespace

std::string mapYaml(const GridGeometry& geometry, const std::string& name, const SavedContent& octree,
                    const SavedContent& picture) {
  std::ostringstream yaml;
  yaml << std::setprecision(std::numeric_limits<double>::digits10);
  yaml << "image: " << yamlText(name + ".pgm") << "\nresolution: " << geometry.resolution << "\norigin: ["
       << geometry.origin.x() << ", " << geometry.origin.y()
       << ", 0.0]\nnegate: 0\noccupied_thresh: " << kOccupiedThreshold << "\nfree_thresh: " << kFreeThreshold << "\n"
       << entryOf(SavedFile::kOctree, name + ".bt", octree) << entryOf(SavedFile::kPicture, name + ".pgm", picture);
  return yaml.str();
}

FileMatch compareWithYaml(const std::string& yaml, SavedFile file, const std::string& content) {
  const ParameterMap map = parseYaml(yaml);
  if (map.count(keyOf(file)) == 0) return FileMatch::kNotMentioned;
  const auto* entry = find<ParameterMap>(map, keyOf(file));
  if (entry == nullptr) return FileMatch::kAnother;
  if (names(*entry, "bytes", "crc32", content)) return FileMatch::kSame;
  return names(*entry, "previous_bytes", "previous_crc32", content) ? FileMatch::kPrevious : FileMatch::kAnother;
}

std::string imageOf(const std::string& yaml) {
  const ParameterMap map = parseYaml(yaml);
  const auto* image = find<std::string>(map, "image");
  return image != nullptr ? *image : "";
}

std::string savedNameOf(const std::string& yaml) {
  const ParameterMap map = parseYaml(yaml);
  const std::string octree = nameIn(map, SavedFile::kOctree, ".bt");
  return octree.empty() ? nameIn(map, SavedFile::kPicture, ".pgm") : octree;
}

std::string withoutOctree(const std::string& yaml) {
  std::istringstream lines(yaml);
  std::string rest;
  bool inside = false;
  for (std::string line; std::getline(lines, line);) {
    // An entry goes on in the lines that are indented or blank.
    inside = line.rfind("octree:", 0) == 0 || (inside && line.find_first_not_of(" \t\r") != 0);
    if (!inside) rest += line + "\n";
  }
  return rest;
}

bool readsAs(const std::string& yaml, const std::string& name, const std::string& octree, const std::string& picture) {
  try {
    return imageOf(yaml) == name + ".pgm" && savedNameOf(yaml) == name &&
           compareWithYaml(yaml, SavedFile::kOctree, octree) == FileMatch::kSame &&
           compareWithYaml(yaml, SavedFile::kPicture, picture) == FileMatch::kSame;
  } catch (const std::invalid_argument&) {
    return false;
  }
}

}  // namespace frontier_pilot::map_files
