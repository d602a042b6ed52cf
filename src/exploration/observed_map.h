#pragma once

#include <cstdint>

#include "exploration/limits/allowed_cells.h"
#include "frontier_pilot/core/grid.h"

namespace frontier_pilot::exploration {

/// The explorer's own copy of the map, on which cells outside of the bounds are occupied: no goal, frontier or path
/// lies there. Counts the cells that change class (unknown, free, occupied) by place, and the known free area. The cost
/// of an update depends on the size of the changed block only.
class ObservedMap {
 public:
  /// Takes over the differences within `changed`, or the whole map if the geometry is new. Returns the block that holds
  /// every cell whose class changed, with a new geometry all cells; empty if none did.
  CellRect update(const OccupancyGrid& map, const CellRect& changed);

  /// Takes effect with an update of the whole map, which is to follow.
  void setBounds(const ExplorationBounds& bounds);
  const ExplorationBounds& bounds() const { return allowed_.bounds(); }

  bool allowed(Cell c) const { return allowed_.allowed(c); }

  const OccupancyGrid& grid() const { return map_; }
  const GridGeometry& geometry() const { return map_.geometry(); }
  bool empty() const { return map_.empty(); }
  /// Known free floor within the bounds [m^2].
  double freeArea() const;
  /// Number of changes of class so far within a square of half side `radius` [m] around `point`, in whole tiles. Only
  /// the difference between two calls is meaningful.
  std::uint64_t changesAround(const Vec2& point, double radius) const;
  /// How often these counts have begun anew: they go on when the map grows, but not where its cells come to lie between
  /// the old ones.
  std::uint32_t restarts() const { return restarts_; }
  /// Number of changes of class so far, in the whole map, and of its geometry.
  std::uint64_t changes() const { return changes_; }

 private:
  static constexpr int kTile = 16;  ///< cells along the side of a tile

  void moveTo(const GridGeometry& geometry);
  void updateRow(const OccupancyGrid& map, int y, int begin, int end, CellRect& differing);
  void updateCell(Cell c, std::int8_t value, CellRect& differing);
  static int withinTile(int cells) { return (cells % kTile + kTile) % kTile; }
  Cell tileOf(Cell c) const { return {(c.x + corner_.x) / kTile, (c.y + corner_.y) / kTile}; }

  OccupancyGrid map_;
  AllowedCells allowed_;
  Grid<std::uint32_t> tiles_;  ///< changes of class per tile
  Cell corner_;                ///< where in the first tile the map begins: tiles stay where they are when the map grows
  std::uint32_t restarts_ = 0;
  std::uint64_t free_cells_ = 0;
  std::uint64_t changes_ = 0;
};

}  // namespace frontier_pilot::exploration
