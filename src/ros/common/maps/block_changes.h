#pragma once

#include <cstdint>
#include <vector>

#include "frontier_pilot/core/grid.h"

namespace frontier_pilot {

/// Knows which blocks of a map, squares of 16 cells along a side, differ from what was sent last. It keeps a hash of 64
/// bits for each block rather than its cells, a thirty-second of the map's size: that a block changes and its hash does
/// not is expected once in 2^64 changes.
class BlockChanges {
 public:
  static constexpr int kSide = 16;  ///< [cells]

  /// Begins with a map of which nothing was sent yet.
  void reset(const GridGeometry& geometry);
  const GridGeometry& geometry() const { return geometry_; }
  /// The blocks that `cells` touches, as far as they lie in the map.
  CellRect blocksAround(const CellRect& cells) const;
  /// Takes `part`, the present values of the blocks `place`, which is what blocksAround() gave, for sent. Returns the
  /// blocks that differ from what was sent before: neighbours of a row as one, from below to above.
  std::vector<CellRect> take(const OccupancyGrid& part, const CellRect& place);

 private:
  int columns() const { return (geometry_.width + kSide - 1) / kSide; }

  GridGeometry geometry_;
  std::vector<std::uint64_t> sent_;  ///< the hash of each block, row by row; zero before the first
};

}  // namespace frontier_pilot
