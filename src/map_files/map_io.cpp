#include "frontier_pilot/map_files/map_io.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "frontier_pilot/core/files.h"
#include "frontier_pilot/map_files/map_image.h"
#include "map_files/grid_drawing.h"
#include "map_files/map_yaml.h"
#include "map_files/resampling.h"

namespace frontier_pilot::map_files {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLongestExtension = 5;  // .yaml
constexpr std::size_t kLongestYaml = 65536;   // [bytes]

MapIoResult failure(MapIoStatus status, const std::string& file, const std::string& what) {
  return {status, file + ": " + what};
}

fs::path withoutExtension(const std::string& path) {
  const fs::path whole(path);
  const std::string extension = whole.extension().string();
  const bool ours = extension == ".pgm" || extension == ".yaml" || extension == ".bt";
  return ours ? fs::path(whole).replace_extension() : whole;
}

MapIoResult checkTarget(const fs::path& base) {
  const std::string problem = fileNameProblem(base.filename().string(), kLongestExtension);
  // The message does not quote the name: what makes it unacceptable (control characters) would also harm a log.
  if (!problem.empty()) return {MapIoStatus::kBadPath, "the map's name " + problem};
  if (base.string().find('\0') != std::string::npos) return {MapIoStatus::kBadPath, "the path holds a NUL character"};
  const fs::path directory = base.has_parent_path() ? base.parent_path() : fs::path(".");
  std::error_code error;
  if (!fs::is_directory(directory, error))
    return failure(MapIoStatus::kBadPath, directory.string(), "no such directory");
  return {};
}

/// A file to be written, and its content, which must outlive this.
struct MapFile {
  MapFile(fs::path path, std::string_view bytes, Survives survives) : file(std::move(path), survives), content(bytes) {}

  std::string name() const { return file.target().string(); }
  MapIoResult cannot(const std::string& what, const std::string& problem) const {
    return failure(MapIoStatus::kCannotWrite, name(), what + ": " + problem);
  }

  AtomicFile file;
  std::string_view content;
};

/// Writes all files under temporary names. Fails before anything is replaced if one of them cannot be written.
MapIoResult prepare(std::array<MapFile, 3>& files) {
  for (MapFile& file : files) {
    std::error_code error;
    if (fs::symlink_status(file.name(), error).type() == fs::file_type::directory)
      return file.cannot("cannot be written", "it is a directory");
    const std::string problem = file.file.write(file.content);
    if (!problem.empty()) return file.cannot("cannot be written", problem);
  }
  return {};
}

MapIoResult putInPlace(std::array<MapFile, 3>& files) {
  std::string done;
  for (MapFile& file : files) {
    std::string problem = file.file.commit();
    if (!problem.empty()) {
      problem.append(done.empty() ? "; nothing was replaced" : "; only these were replaced:").append(done);
      return file.cannot("cannot be put in place", problem);
    }
    done.append(done.empty() ? " " : ", ").append(file.name());
  }
  return {};
}

/// Whether a file contains `content` and nothing else. It is read in pieces: `content` may be as large as a map.
bool holds(const std::string& path, std::string_view content) {
  constexpr std::size_t kPiece = 1U << 20U;  // [bytes]
  std::ifstream file(path, std::ios::binary);
  std::vector<char> piece(kPiece);
  while (file.read(piece.data(), kPiece) || file.gcount() > 0) {
    const auto count = static_cast<std::size_t>(file.gcount());
    if (content.substr(0, count) != std::string_view(piece.data(), count)) return false;
    content.remove_prefix(count);
  }
  return file.eof() && content.empty();
}

/// Checks that the files contain what was written.
MapIoResult readBack(const std::array<MapFile, 3>& files) {
  for (const MapFile& file : files) {
    if (!holds(file.name(), file.content))
      return file.cannot("cannot be read back", "its content is not what was written");
  }
  return {};
}

std::string appended(const fs::path& base, const char* extension) { return base.string() + extension; }

MapIoResult cannotRead(const std::string& path, const FileContent& content) {
  const bool missing = content.status == FileContent::Status::kMissing;
  return failure(missing ? MapIoStatus::kMissing : MapIoStatus::kBroken, path, content.problem);
}

/// Whether the YAML beside a .bt, if there is one, was written with it. If that is not certain, the text says so.
MapIoResult compareWithYaml(const std::string& yaml_path, const std::string& bt_path, const std::string& octree) {
  const FileContent yaml = readFile(yaml_path, kLongestYaml);
  if (yaml.status == FileContent::Status::kMissing) return {MapIoStatus::kOk, ", not verified: it has no YAML"};
  if (!yaml.ok()) return cannotRead(yaml_path, yaml);
  try {
    switch (compareOctree(yaml.bytes, octree)) {
      case OctreeMatch::kSame:
        return {};
      case OctreeMatch::kNotMentioned:
        return {MapIoStatus::kOk, ", not verified: its YAML holds no checksum"};
      case OctreeMatch::kPrevious:
        return {MapIoStatus::kOk, ", as it was before the last save, which was not completed"};
      case OctreeMatch::kAnother:
        break;
    }
  } catch (const std::invalid_argument& error) {
    return failure(MapIoStatus::kBroken, yaml_path, error.what());
  }
  return failure(MapIoStatus::kBroken, bt_path,
                 "is not the one that " + yaml_path + " was written with: length or checksum differs");
}

/// Whether there is a YAML that mentions no octree, as other programs write it. A YAML that `saveMap` wrote and whose
/// .bt is missing belongs to a damaged map.
bool isOfAnotherProgram(const std::string& yaml_path) {
  const FileContent yaml = readFile(yaml_path, kLongestYaml);
  try {
    return yaml.ok() && compareOctree(yaml.bytes, {}) == OctreeMatch::kNotMentioned;
  } catch (const std::invalid_argument&) {
    return true;  // reading it as a map image reports what is wrong with it
  }
}

/// The content of the .bt that a save is about to replace, if it is a map that can be loaded.
std::optional<std::string> previousOctree(const fs::path& base, std::size_t most_bytes) {
  const std::string bt = appended(base, ".bt");
  FileContent octree = readFile(bt, most_bytes);
  if (!octree.ok() || !compareWithYaml(appended(base, ".yaml"), bt, octree.bytes).ok()) return std::nullopt;
  return std::move(octree.bytes);
}

MapIoResult loadBytes(const std::string& bt_path, const std::string& bytes, occupancy::OccupancyMap& map) {
  std::string why;
  if (!map.read(bytes, why)) return failure(MapIoStatus::kBroken, bt_path, why);
  return {MapIoStatus::kOk, "loaded " + bt_path};
}

std::string inMetres(double length) {
  std::ostringstream text;
  text << length << " m";
  return text.str();
}

/// Loads a map without an octree, as another program has saved it.
MapIoResult loadPicture(const std::string& yaml_path, occupancy::OccupancyMap& map) {
  constexpr double kSame = 1e-6;  // [m]: tolerance for resolutions that were typed by hand
  std::string change;
  try {
    const MapImage image = readMapImage(yaml_path);
    const double resolution = map.parameters().resolution;
    const bool same = std::abs(image.map.resolution() - resolution) <= kSame;
    const std::optional<OccupancyGrid> fitting = same ? std::nullopt : resampled(image.map, resolution);
    occupancy::OccupancyMap drawn(map.parameters());
    const bool has_room = (same || fitting) && draw(same ? image.map : *fitting, drawn);
    if (has_room && drawn.isBlank()) return failure(MapIoStatus::kBroken, yaml_path, "its image holds no known cell");
    if (!has_room || !map.exchange(drawn)) return failure(MapIoStatus::kBroken, yaml_path, "is too large");
    if (!same) change = "; its cells of " + inMetres(image.map.resolution()) + " have become " + inMetres(resolution);
  } catch (const std::runtime_error& error) {
    return {MapIoStatus::kBroken, error.what()};
  }
  return {MapIoStatus::kOk, "loaded " + yaml_path + " from its image: it has no octree" + change};
}

}  // namespace

const char* toString(MapIoStatus status) {
  switch (status) {
    case MapIoStatus::kOk:
      return "ok";
    case MapIoStatus::kBadPath:
      return "bad path";
    case MapIoStatus::kEmptyMap:
      return "empty map";
    case MapIoStatus::kCannotWrite:
      return "cannot write";
    case MapIoStatus::kMissing:
      return "missing file";
    case MapIoStatus::kBroken:
      return "broken file";
  }
  return "unknown";
}

MapSnapshot takeSnapshot(const occupancy::OccupancyMap& map) {
  MapSnapshot snapshot{map.geometry(), map.isBlank(), {}, {}, map.mostBytes()};
  if (snapshot.blank) return snapshot;
  snapshot.picture = pgmOf(map);
  std::ostringstream octree;
  if (map.write(octree)) snapshot.octree = octree.str();
  return snapshot;
}

MapIoResult saveMap(const occupancy::OccupancyMap& map, const std::string& path) {
  return saveMap(takeSnapshot(map), path);
}

MapIoResult saveGrid(const OccupancyGrid& grid, const std::string& path) {
  occupancy::OccupancyMapParameters parameters;
  parameters.resolution = grid.resolution();
  parameters.max_memory = 16000.0;  // [MB]: no limit of its own for a map that is in memory already
  occupancy::OccupancyMap map(parameters);
  if (!draw(grid, map)) return {MapIoStatus::kCannotWrite, "the map is too large"};
  return saveMap(map, path);
}

MapIoResult saveMap(const MapSnapshot& map, const std::string& path, Survives survives) {
  const fs::path base = withoutExtension(path);
  MapIoResult result = checkTarget(base);
  if (!result.ok()) return result;
  // A map without any known cell could not be loaded again, and might replace one that can.
  if (map.blank) return {MapIoStatus::kEmptyMap, "the map is empty"};
  if (map.octree.empty()) return {MapIoStatus::kCannotWrite, "the octree cannot be written"};
  const std::string name = base.filename().string();
  const std::string yaml = mapYaml(map.geometry, name, map.octree, previousOctree(base, map.most_bytes));
  // The YAML is replaced first: it has the checksums of the .bt that exists and of the one that will replace it.
  std::array<MapFile, 3> files = {MapFile(appended(base, ".yaml"), yaml, survives),
                                  MapFile(appended(base, ".bt"), map.octree, survives),
                                  MapFile(appended(base, ".pgm"), map.picture, survives)};
  if (!readsAs(yaml, name, map.octree))
    return files.front().cannot("cannot be written", "it could not be parsed again");
  for (const auto step : {prepare, putInPlace}) {
    result = step(files);
    if (!result.ok()) return result;
  }
  result = readBack(files);
  if (result.ok()) result.text = "saved " + fs::absolute(base).lexically_normal().string() + ".pgm, .yaml and .bt";
  return result;
}

MapIoResult loadMap(const std::string& path, occupancy::OccupancyMap& map) {
  const fs::path base = withoutExtension(path);
  const std::string problem = fileNameProblem(base.filename().string(), kLongestExtension);
  if (!problem.empty()) return {MapIoStatus::kBadPath, "the map's name " + problem};
  const std::string bt = appended(base, ".bt");
  const FileContent octree = readFile(bt, map.mostBytes());
  const std::string yaml = appended(base, ".yaml");
  if (octree.status == FileContent::Status::kMissing && isOfAnotherProgram(yaml)) return loadPicture(yaml, map);
  if (!octree.ok()) return cannotRead(bt, octree);
  MapIoResult belongs = compareWithYaml(yaml, bt, octree.bytes);
  if (!belongs.ok()) return belongs;
  MapIoResult result = loadBytes(bt, octree.bytes, map);
  if (result.ok()) result.text += belongs.text;
  return result;
}

MapIoResult loadOctree(const std::string& bt_path, occupancy::OccupancyMap& map) {
  const FileContent octree = readFile(bt_path, map.mostBytes());
  return octree.ok() ? loadBytes(bt_path, octree.bytes, map) : cannotRead(bt_path, octree);
}

}  // namespace frontier_pilot::map_files
