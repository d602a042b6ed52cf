#include "examples.h"

#include "frontier_pilot/occupancy/scan_inserter.h"
#include "room.h"

namespace fp = frontier_pilot;

bool examples::occupancy() {
  //! [example]
  fp::occupancy::OccupancyMap map;
  fp::occupancy::ScanInserter inserter;
  const fp::Pose2 T_map_base(0.0, 0.02, 0.0);
  for (int i = 0; i < 3; ++i) {
    const fp::occupancy::Insertion insertion =
        inserter.insert(fp::surfaces::readScan(scanFrom(T_map_base)), T_map_base, map);
    if (insertion != fp::occupancy::Insertion::kInserted) return false;  // and the map is as it was
  }
  const fp::OccupancyGrid& grid = map.grid();
  const bool wall = fp::isOccupied(grid[grid.geometry().cellAt({3.02, 0.02})]);
  return wall && fp::isFree(grid[grid.geometry().cellAt({1.02, 0.52})]) && map.takeChanges().geometry_changed;
  //! [example]
}
