#pragma once

#include <string>

#include "frontier_pilot/core/files.h"
#include "frontier_pilot/core/grid.h"
#include "frontier_pilot/occupancy/occupancy_map.h"

namespace frontier_pilot::map_files {

enum class MapIoStatus {
  kOk,
  kBadPath,      ///< the path names no file, or one that cannot be read again, or its directory does not exist
  kEmptyMap,     ///< there is nothing to save: no cell is known
  kCannotWrite,  ///< the disk is full, or writing is not allowed
  kMissing,      ///< a file to load does not exist
  kBroken,       ///< a file to load is not what it should be
};

const char* toString(MapIoStatus status);

struct MapIoResult {
  MapIoStatus status = MapIoStatus::kOk;
  std::string text;  ///< for people: what was done, or what is wrong with which file

  bool ok() const { return status == MapIoStatus::kOk; }
};

/// What of a map goes into its files, as it was at one moment: it shares nothing with the map, so that another thread
/// may write it.
struct MapSnapshot {
  OccupancyGrid grid;
  std::string octree;          ///< the bytes of the .bt file; none when the octree cannot be written
  std::size_t most_bytes = 0;  ///< that such a file may have
};
MapSnapshot takeSnapshot(occupancy::OccupancyMap& map);

/// Writes `path`.pgm and `path`.yaml (map_server's trinary format) and `path`.bt (OctoMap's binary one); an extension
/// of these three is ignored. Each file appears whole or not at all; they are read back before success is told. The
/// YAML comes first, with length and checksum of the .bt and of the one before it, so that at any moment one of the two
/// maps can be loaded. Where only some files could be put in place the text names them. [FLT-1]
MapIoResult saveMap(const MapSnapshot& map, const std::string& path, Survives survives = Survives::kPowerLoss);
MapIoResult saveMap(occupancy::OccupancyMap& map, const std::string& path);

/// Replaces `map` by what `saveMap` wrote to `path`: its .bt file, whatever the extension. If a YAML is there the two
/// must belong together; the text says where that is not known. A map without a .bt, such as map_saver writes it, is
/// read from its YAML and picture: its known cells are then as sure as cells may be, and its resolution must be the
/// map's. On failure the map stays as it was. [MAP-5]
MapIoResult loadMap(const std::string& path, occupancy::OccupancyMap& map);

/// Replaces `map` by a .bt file's content; on failure it stays as it was.
MapIoResult loadOctree(const std::string& bt_path, occupancy::OccupancyMap& map);

}  // namespace frontier_pilot::map_files
