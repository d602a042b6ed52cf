#pragma once

#include <string>

#include "frontier_pilot/core/files.h"
#include "frontier_pilot/core/grid.h"
#include "frontier_pilot/occupancy/occupancy_map.h"

namespace frontier_pilot::map_files {

enum class MapIoStatus {
  kOk,
  kBadPath,      ///< the name is not acceptable as a file name, or the directory does not exist
  kEmptyMap,     ///< nothing to save: no cell is known
  kCannotWrite,  ///< a file could not be written, for example because the disk is full
  kMissing,      ///< a file to load does not exist
  kBroken,       ///< a file to load is malformed or does not fit the map
};

const char* toString(MapIoStatus status);

struct MapIoResult {
  MapIoStatus status = MapIoStatus::kOk;
  std::string text;       ///< in words: what was done, or what is wrong with which file
  bool doubtful = false;  ///< what was loaded may not be the map that is meant; the text says why

  bool ok() const { return status == MapIoStatus::kOk; }
};

/// A copy of everything of a map that goes into its files. It shares nothing with the map, so that another thread may
/// write the files.
struct MapSnapshot {
  GridGeometry geometry;       ///< of the map
  bool blank = true;           ///< no cell is known
  std::string picture;         ///< the bytes of the .pgm file
  std::string octree;          ///< the bytes of the .bt file; empty when the octree could not be serialised
  std::size_t most_bytes = 0;  ///< the largest size that a .bt file of such a map may have
};
MapSnapshot takeSnapshot(const occupancy::OccupancyMap& map);

/// Writes `path`.pgm and `path`.yaml (map_server's trinary format) and `path`.bt (OctoMap's binary format); if `path`
/// ends in one of these extensions it is ignored. Each file appears complete or not at all, and all are read back
/// before success is reported. At any moment one of the two maps can be loaded: the YAML is replaced before the .bt,
/// and holds length and checksum of both the new and the previous one; where the previous map is loaded from its
/// picture, the .bt is replaced before a YAML that names it. If only some files could be replaced, the text names them.
/// Saves in one folder, also of other processes, wait for each other, for at most ten seconds. [FLT-1]
MapIoResult saveMap(const MapSnapshot& map, const std::string& path, Survives survives = Survives::kPowerLoss);
MapIoResult saveMap(const occupancy::OccupancyMap& map, const std::string& path);
/// The same for a map of which only the cells' classes are known: known cells get the greatest certainty that the
/// occupancy model allows.
MapIoResult saveGrid(const OccupancyGrid& grid, const std::string& path);

/// Replaces `map` by what `saveMap` wrote to `path`, that is its .bt file, whichever extension `path` has. If a YAML
/// exists, the .bt must match its checksum; the text says so if that could not be verified. A map without a .bt, as
/// map_saver writes it, is read from its YAML and image: its known cells get the greatest certainty that the occupancy
/// model allows; cells of another size become cells of the map's. On failure `map` is unchanged. [MAP-5]
MapIoResult loadMap(const std::string& path, occupancy::OccupancyMap& map);

/// Replaces `map` by the content of a .bt file; on failure it is unchanged.
MapIoResult loadOctree(const std::string& bt_path, occupancy::OccupancyMap& map);

}  // namespace frontier_pilot::map_files
