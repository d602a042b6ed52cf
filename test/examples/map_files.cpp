#include "examples.h"

#include "frontier_pilot/map_files/map_io.h"
#include "frontier_pilot/occupancy/scan_inserter.h"
#include "room.h"

namespace fp = frontier_pilot;

bool examples::mapFiles(const std::string& folder) {
  //! [example]
  fp::occupancy::OccupancyMap map;
  fp::occupancy::ScanInserter().insert(fp::surfaces::readScan(scanFrom({})), {}, map);
  const fp::map_files::MapIoResult saved = fp::map_files::saveMap(map, folder + "/room");  // .pgm, .yaml and .bt
  fp::occupancy::OccupancyMap loaded;
  const fp::map_files::MapIoResult read = fp::map_files::loadMap(folder + "/room", loaded);
  if (!saved.ok() || !read.ok()) return false;  // `text` says what is wrong with which file
  return fp::isFree(loaded.grid()[loaded.geometry().cellAt({1.02, 0.52})]);
  //! [example]
}
