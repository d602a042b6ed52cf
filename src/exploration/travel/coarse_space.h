#pragma once

#include <cstdint>

#include "exploration/travel/travel_field.h"
#include "frontier_pilot/core/grid.h"

namespace frontier_pilot::exploration {

/// A TraversableSpace in cells of three times the size, for travel distances between many places. A cell is traversable
/// if one of the nine it stands for is. Two neighbours never lie on different sides of a wall as long as the clearance
/// of the space is at least 3.5 of its cells.
class CoarseSpace {
 public:
  static constexpr int kFactor = 3;

  /// Takes over the cells of `space` within `changed`; all cells if the geometry is new.
  void update(const TraversableSpace& space, const CellRect& changed);

  /// As TraversableSpace::neighbours().
  const Grid<std::uint8_t>& neighbours() const { return neighbours_; }
  const GridGeometry& geometry() const { return passable_.geometry(); }

 private:
  void mark(const TraversableSpace& space, const CellRect& window);

  Grid<std::uint8_t> passable_;  ///< 0xFF or 0
  Grid<std::uint8_t> neighbours_;
};

}  // namespace frontier_pilot::exploration
