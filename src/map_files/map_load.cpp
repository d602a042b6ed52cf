#include <chrono>
#include <cmath>
#include <optional>
#include <sstream>
#include <stdexcept>

#include "frontier_pilot/core/bounds.h"
#include "frontier_pilot/core/files.h"
#include "frontier_pilot/map_files/map_image.h"
#include "frontier_pilot/map_files/map_io.h"
#include "map_files/folder_lock.h"
#include "map_files/grid_drawing.h"
#include "map_files/map_file_set.h"
#include "map_files/resampling.h"

namespace frontier_pilot::map_files {
namespace {

MapIoResult cannotRead(const std::string& path, const FileContent& content) {
  const bool missing = content.status == FileContent::Status::kMissing;
  return failure(missing ? MapIoStatus::kMissing : MapIoStatus::kBroken, path, content.problem);
}

/// A damaged map is not loaded from its picture unless somebody says so: this tells how. [MAP-5]
MapIoResult withWayOut(MapIoResult result, const MapFileSet& files) {
  if (!result.ok()) result.text += files.wayOut();
  return result;
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

/// Loads a map from its image, the one that its YAML names if `picture` names none; `why` that is done is told with it.
MapIoResult loadPicture(const std::string& yaml_path, const std::string& picture, const std::string& why,
                        occupancy::OccupancyMap& map) {
  constexpr double kSame = 1e-6;  // [m]: tolerance for resolutions that were typed by hand
  std::string change;
  try {
    const MapImage image = readMapImage(yaml_path, picture);
    const double resolution = map.parameters().resolution;
    const bool same = std::abs(image.map.resolution() - resolution) <= kSame;
    const std::optional<OccupancyGrid> fitting = same ? std::nullopt : resampled(image.map, resolution);
    occupancy::OccupancyMap drawn(map.parameters());
    const std::string too_large = map.describe(occupancy::MapRoom::kTooLarge);
    std::string problem = too_large;
    if (same || fitting) problem = draw(same ? image.map : *fitting, drawn);
    if (problem.empty() && drawn.isBlank()) problem = "its image holds no known cell";
    if (problem.empty() && !map.exchange(drawn)) problem = too_large;
    if (!problem.empty()) return failure(MapIoStatus::kBroken, yaml_path, problem);
    if (!same) change = "; its cells of " + inMetres(image.map.resolution()) + " have become " + inMetres(resolution);
  } catch (const std::runtime_error& error) {
    return {MapIoStatus::kBroken, error.what()};
  }
  return {MapIoStatus::kOk, "loaded " + yaml_path + " from its image: " + why + change};
}

}  // namespace

MapIoResult loadMap(const std::string& path, occupancy::OccupancyMap& map) {
  const MapFileSet files(path);
  const std::string problem = files.nameProblem();
  if (!problem.empty()) return {MapIoStatus::kBadPath, problem};
  // So that no file is read in the middle of a save. After a second they are read anyway: the checksums show whether
  // the files belong together.
  const FolderLock lock(files.folder(), FolderLock::Kind::kRead, std::chrono::seconds(1));
  const FileContent octree = readFile(files.octree(), map.mostBytes());
  const std::optional<MapFileSet::Picture> other = files.otherPicture();
  if (octree.status == FileContent::Status::kMissing && files.isOfAnotherProgram())
    return loadPicture(files.yaml(), other ? other->path : "", "it has no octree", map);
  if (!octree.ok()) return withWayOut(cannotRead(files.octree(), octree), files);
  MapIoResult belongs = files.compareOctree(octree.bytes);
  if (!belongs.ok()) return withWayOut(belongs, files);
  if (other && other->counts) {
    MapIoResult drawn = loadPicture(files.yaml(), other->path, other->why, map);
    if (drawn.ok()) return drawn;
    belongs.text += "; its image should count, because " + other->why + ", but cannot be used: " + drawn.text;
    belongs.doubtful = true;
  } else if (other && belongs.text.empty()) {  // the octree is that of the last save
    belongs.text += "; its image does not count, because " + other->why;
    belongs.doubtful = true;
  }
  MapIoResult result = loadBytes(files.octree(), octree.bytes, map);
  if (!result.ok() && !other) return withWayOut(result, files);
  result.text += belongs.text;
  result.doubtful = belongs.doubtful;
  return result;
}

MapIoResult loadOctree(const std::string& bt_path, occupancy::OccupancyMap& map) {
  const FileContent octree = readFile(bt_path, map.mostBytes());
  return octree.ok() ? loadBytes(bt_path, octree.bytes, map) : cannotRead(bt_path, octree);
}

}  // namespace frontier_pilot::map_files
