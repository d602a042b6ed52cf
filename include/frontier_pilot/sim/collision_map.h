#pragma once

#include <cstdint>
#include <optional>

#include "frontier_pilot/core/distance_field.h"
#include "frontier_pilot/core/grid.h"

namespace frontier_pilot::sim {

/// Where a disc fits between the solid cells of a world. What lies outside of the grid is solid. [SIM-3]
class CollisionMap {
 public:
  CollisionMap(const Grid<std::uint8_t>& solid, double radius);

  double radius() const { return radius_; }
  /// Whether a disc at `centre` [m], `margin` [m] larger than it is, overlaps a solid cell, exactly; touching is not
  /// overlapping.
  bool overlaps(const Vec2& centre, double margin = 0.0) const;
  /// Whether a disc at `centre` and anywhere within `reach` [m] of it surely overlaps nothing. One look-up.
  bool surelyFree(const Vec2& centre, double reach) const { return clearance_.at(centre) > needed_ + reach; }
  /// The centre of the cell nearest to `point` where a disc fits, if there is any.
  std::optional<Vec2> nearestFree(const Vec2& point) const;

 private:
  Grid<std::uint8_t> solid_;  ///< with a solid ring around it
  double radius_;
  double needed_;            ///< clearance of a cell's centre that is enough for any point in the cell [m]
  DistanceField clearance_;  ///< between centres of cells [m]
};

}  // namespace frontier_pilot::sim
