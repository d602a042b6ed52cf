#include "frontier_pilot/map_files/map_io.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "frontier_pilot/core/bounds.h"
#include "frontier_pilot/core/files.h"
#include "frontier_pilot/map_files/map_image.h"
#include "map_files/folder_lock.h"
#include "map_files/grid_drawing.h"
#include "map_files/map_file_set.h"
#include "map_files/map_yaml.h"

namespace frontier_pilot::map_files {
namespace {

namespace fs = std::filesystem;

MapIoResult checkTarget(const MapFileSet& files) {
  const std::string problem = files.nameProblem();
  if (!problem.empty()) return {MapIoStatus::kBadPath, problem};
  if (files.base().string().find('\0') != std::string::npos)
    return {MapIoStatus::kBadPath, "the path holds a NUL character"};
  std::error_code error;
  const std::string folder = files.folder().string();
  const bool is_homes = folder[0] == '~';
  if (!fs::is_directory(folder, error))
    return failure(MapIoStatus::kBadPath, folder,
                   is_homes ? "only a shell replaces '~'; begin the path with /" : "no such directory");
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

using MapFiles = std::array<MapFile*, 3>;

/// Writes all files under temporary names. Fails before anything is replaced if one of them cannot be written.
MapIoResult prepare(const MapFiles& files) {
  for (MapFile* file : files) {
    std::error_code error;
    if (fs::symlink_status(file->name(), error).type() == fs::file_type::directory)
      return file->cannot("cannot be written", "it is a directory");
    const std::string problem = file->file.write(file->content);
    if (!problem.empty()) return file->cannot("cannot be written", problem);
  }
  return {};
}

/// `done` names what has been replaced before.
MapIoResult putInPlace(const MapFiles& files, std::string done) {
  for (MapFile* file : files) {
    std::string problem = file->file.commit();
    if (!problem.empty()) {
      problem.append(done.empty() ? "; nothing was replaced" : "; only these were replaced:").append(done);
      return file->cannot("cannot be put in place", problem);
    }
    done.append(done.empty() ? " " : ", ").append(file->name());
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
MapIoResult readBack(const MapFiles& files) {
  for (const MapFile* file : files) {
    if (!holds(file->name(), file->content))
      return file->cannot("cannot be read back", "its content is not what was written");
  }
  return {};
}

/// The content of the .bt that a save is about to replace, if it is a map that can be loaded.
std::optional<std::string> previousOctree(const MapFileSet& files, std::size_t most_bytes) {
  FileContent octree = readFile(files.octree(), most_bytes);
  if (!octree.ok() || !files.compareOctree(octree.bytes).ok()) return std::nullopt;
  return std::move(octree.bytes);
}

/// The content of the picture that a save is about to replace.
std::optional<std::string> previousPicture(const MapFileSet& files) {
  FileContent picture = readFile(files.picture(), bounds::kMostImageBytes);
  if (!picture.ok()) return std::nullopt;
  return std::move(picture.bytes);
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
  // No limits of its own for a map that is in memory already; a few cells more for what is reserved around it.
  parameters.growth_step = grid.resolution();
  parameters.max_side = (std::max(grid.width(), grid.height()) + 8) * grid.resolution();
  parameters.max_memory = 16000.0;  // [MB]
  occupancy::OccupancyMap map(parameters);
  const std::string problem = draw(grid, map);
  if (!problem.empty()) return {MapIoStatus::kCannotWrite, "the map " + problem};
  return saveMap(map, path);
}

MapIoResult saveMap(const MapSnapshot& map, const std::string& path, Survives survives) {
  const MapFileSet target(path);
  MapIoResult result = checkTarget(target);
  if (!result.ok()) return result;
  // A map without any known cell could not be loaded again, and might replace one that can.
  if (map.blank) return {MapIoStatus::kEmptyMap, "the map is empty"};
  if (map.octree.empty()) return {MapIoStatus::kCannotWrite, "the octree cannot be written"};
  // Who holds the lock for longer than this has been stopped, or hangs: its map must not cost this one.
  const FolderLock lock(target.folder(), FolderLock::Kind::kWrite, std::chrono::seconds(10));
  const std::optional<std::string> previous = previousOctree(target, map.most_bytes);
  // A map that is loaded from its picture although there is an octree: its YAML is made to name no octree first,
  // because its picture would not count any more for a YAML that names it as the one to be replaced.
  const std::optional<std::string> alone = previous ? target.yamlOfPictureAlone() : std::nullopt;
  const std::string text =
      mapYaml(map.geometry, target.name(), {map.octree, previous}, {map.picture, previousPicture(target)});
  MapFile yaml(target.yaml(), text, survives);
  MapFile octree(target.octree(), map.octree, survives);
  MapFile picture(target.picture(), map.picture, survives);
  // The YAML has the checksums of the files that exist and of those that will replace them, so it is replaced first. If
  // the one that exists names no octree, a new octree does not count yet, and the new YAML must not name one that is
  // missing or does not count.
  const bool octree_counts = target.namesOctree() && !alone;
  const MapFiles files = octree_counts ? MapFiles{&yaml, &octree, &picture} : MapFiles{&octree, &yaml, &picture};
  if (!readsAs(text, target.name(), map.octree, map.picture))
    return yaml.cannot("cannot be written", "it could not be parsed again");
  result = prepare(files);
  if (!result.ok()) return result;
  if (alone) {
    const std::string problem = writeFile(target.yaml(), *alone, survives);
    if (!problem.empty()) return yaml.cannot("cannot be put in place", problem + "; nothing was replaced");
  }
  result = putInPlace(files, alone ? " the entry octree in " + target.yaml() : "");
  if (!result.ok()) return result;
  result = readBack(files);
  if (result.ok())
    result.text = "saved " + fs::absolute(target.base()).lexically_normal().string() + ".pgm, .yaml and .bt";
  return result;
}

}  // namespace frontier_pilot::map_files
