#pragma once

#include <cstdint>

#include "exploration/travel/travel_field.h"
#include "frontier_pilot/core/grid.h"

namespace frontier_pilot::exploration {

/// A TraversableSpace in cells of up to three times the size, for travel distances between many places. A cell is
/// traversable if one of those it stands for is. The cells are as large as the clearance of the space allows for
/// neighbours never to lie on different sides of a wall, however thin.
class CoarseSpace {
 public:
  /// Takes over the cells of `space` within `changed`; all cells if the geometry is new. Returns the block of its own
  /// cells that has been computed.
  CellRect update(const TraversableSpace& space, const CellRect& changed);

  /// As TraversableSpace::neighbours(), but cells that only touch at a corner are no neighbours if both cells beside
  /// them are blocked and the space does not lead through the corner.
  const Grid<std::uint8_t>& neighbours() const { return neighbours_; }
  const GridGeometry& geometry() const { return passable_.geometry(); }

 private:
  void mark(const TraversableSpace& space, const CellRect& window);
  void cutCorners(const TraversableSpace& space, const CellRect& window);

  int factor_ = 1;
  Grid<std::uint8_t> passable_;  ///< 0xFF or 0
  Grid<std::uint8_t> neighbours_;
};

}  // namespace frontier_pilot::exploration
