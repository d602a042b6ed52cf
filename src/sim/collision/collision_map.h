#pragma once

#include <cstdint>
#include <optional>

#include "frontier_pilot/core/grid.h"
#include "frontier_pilot/core/outline.h"
#include "frontier_pilot/grids/distance_field.h"
#include "sim/collision/outline_collision.h"

namespace frontier_pilot::sim {

/// Where a robot fits between the solid cells of a world. Everything outside of the grid is solid. [SIM-3]
class CollisionMap {
 public:
  /// `greatest_radius` [m]: of the discs that are asked for with `surelyFree`; larger ones are never surely free.
  CollisionMap(const Grid<std::uint8_t>& solid, double greatest_radius);

  /// Whether an outline overlaps a solid cell, exactly; touching is not overlapping.
  bool overlaps(const PlacedOutline& placed) const;
  /// True only if a disc of `radius` [m] overlaps nothing at `centre` and anywhere within `reach` [m] of it. One
  /// look-up.
  bool surelyFree(const Vec2& centre, double radius, double reach) const {
    return clearance_.at(centre) > radius + diagonal_ + reach;
  }
  /// The centre of the cell nearest to `pose` at which the outline fits with the yaw of `pose`, if there is any.
  std::optional<Vec2> nearestFree(const Outline& outline, const Pose2& pose) const;

 private:
  Grid<std::uint8_t> solid_;  ///< with a solid ring around it
  double diagonal_;           ///< of a cell [m]: a disc anywhere in a cell is free if its centre has so much more room
  grids::DistanceField clearance_;  ///< between centres of cells [m]
};

}  // namespace frontier_pilot::sim
