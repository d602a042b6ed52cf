#pragma once

#include <cstdint>
#include <vector>

#include "frontier_pilot/core/grid.h"
#include "frontier_pilot/exploration/parameters.h"

namespace frontier_pilot::exploration {

/// The bounds of an exploration on the cells of a map: a cell is allowed if its centre is. The raster is made once for
/// each geometry, and only if there are bounds. [EXP-10]
class AllowedCells {
 public:
  /// `bounds` have to be free of problems. Takes effect with the next `cover`.
  void setBounds(const ExplorationBounds& bounds) { bounds_ = bounds; }
  void cover(const GridGeometry& geometry);

  const ExplorationBounds& bounds() const { return bounds_; }
  bool all() const { return outside_.empty(); }
  /// No cell outside of the grid is allowed if there are bounds.
  bool allowed(Cell c) const { return all() || outside_.get(c, 1) == 0; }
  /// Cells [begin, end) of a row of the map, those that are not allowed occupied. Returns `row` itself if all are
  /// allowed, otherwise a buffer that is as long and valid until the next call; only these cells of it are filled in.
  const std::int8_t* shown(const std::int8_t* row, int y, int begin, int end);

 private:
  void fill(const std::vector<Vec2>& corners, std::uint8_t value);

  ExplorationBounds bounds_;
  Grid<std::uint8_t> outside_;  ///< 1 where a cell is not allowed; empty if all are
  std::vector<std::int8_t> row_;
};

}  // namespace frontier_pilot::exploration
