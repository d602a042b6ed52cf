#pragma once

#include <cstdint>

#include "frontier_pilot/core/grid.h"

namespace frontier_pilot::grids {

/// Exact Euclidean distance [m] from each cell's centre to the nearest obstacle cell's centre, cut off at a maximum.
/// Therefore a change affects only cells within `max_distance`, and the cost of an update depends on the changed block,
/// not on the map.
/// Felzenszwalb & Huttenlocher, "Distance Transforms of Sampled Functions", Theory of Computing 8, 2012.
class DistanceField {
 public:
  DistanceField() = default;
  /// `obstacle`: non-zero where one is. `max_distance` [m] > 0 is what cells farther from every obstacle get.
  DistanceField(const Grid<std::uint8_t>& obstacle, double max_distance);

  /// Recomputes the cells that a change of `obstacle` within `changed` can affect. The geometry must not have changed.
  void update(const Grid<std::uint8_t>& obstacle, const CellRect& changed);

  const GridGeometry& geometry() const { return distance_.geometry(); }
  bool empty() const { return distance_.empty(); }
  double maxDistance() const { return max_distance_; }
  const Grid<float>& grid() const { return distance_; }
  float operator[](Cell c) const { return distance_[c]; }
  /// 0 outside of the grid.
  double at(Cell c) const { return distance_.get(c, 0.0F); }
  double at(const Vec2& point) const { return at(geometry().cellAt(point)); }

 private:
  void compute(const Grid<std::uint8_t>& obstacle, const CellRect& window);

  double max_distance_ = 0.0;
  Grid<float> distance_;
};

}  // namespace frontier_pilot::grids
