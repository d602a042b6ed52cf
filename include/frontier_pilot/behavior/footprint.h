#pragma once

#include <vector>

#include "frontier_pilot/behavior/parameters.h"
#include "frontier_pilot/core/grid.h"

namespace frontier_pilot {

/// The robot's outline as a polygon in the base frame [m].
class Footprint {
 public:
  explicit Footprint(const FootprintParameters& parameters);

  const std::vector<Vec2>& corners() const { return corners_; }
  /// Distance [m] from the base's origin to the farthest corner.
  double radius() const { return radius_; }
  /// Every cell of `geometry`'s raster that the outline at `pose` touches or holds, inside the grid or not, in no
  /// order; a cell may come twice. `cells` is overwritten, so that a caller can keep its memory.
  void cellsAt(const Pose2& pose, const GridGeometry& geometry, std::vector<Cell>& cells) const;

 private:
  std::vector<Vec2> corners_;
  double radius_ = 0.0;
};

}  // namespace frontier_pilot
