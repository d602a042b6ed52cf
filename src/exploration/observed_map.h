#pragma once

#include <cstdint>
#include <vector>

#include "frontier_pilot/core/grid.h"

namespace frontier_pilot::exploration {

/// The explorer's own copy of the map, which knows what really changed: how many cells went from one class (unknown,
/// free, occupied) to another, where, and how much floor is known. An update costs the block it is told of.
class ObservedMap {
 public:
  /// Takes over what differs within `changed`, all of it when the geometry is a new one. Gives the block that holds
  /// every cell whose class changed; empty if none did. Old change counts are lost with the old geometry.
  CellRect update(const OccupancyGrid& map, const CellRect& changed);

  const OccupancyGrid& grid() const { return map_; }
  const GridGeometry& geometry() const { return map_.geometry(); }
  bool empty() const { return map_.empty(); }
  /// Known free floor [m^2].
  double freeArea() const;
  /// Cells that have ever changed class within a square of half side `radius` [m] around `point`, in whole tiles.
  /// Only differences between two calls mean something.
  std::uint64_t changesAround(const Vec2& point, double radius) const;
  /// Cells that have ever changed class.
  std::uint64_t changes() const { return changes_; }

 private:
  static constexpr int kTile = 16;  ///< cells along the side of a tile

  void restart(const GridGeometry& geometry);
  void updateRow(const OccupancyGrid& map, int y, int begin, int end, CellRect& differing);
  void updateCell(Cell c, std::int8_t value, CellRect& differing);
  std::uint32_t& tile(Cell c) {
    return tiles_[static_cast<std::size_t>(c.y / kTile) * tiles_per_row_ + static_cast<std::size_t>(c.x / kTile)];
  }

  OccupancyGrid map_;
  std::vector<std::uint32_t> tiles_;  ///< changes of class per tile
  std::size_t tiles_per_row_ = 0;
  std::uint64_t free_cells_ = 0;
  std::uint64_t changes_ = 0;
};

}  // namespace frontier_pilot::exploration
