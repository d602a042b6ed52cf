#pragma once

#include <cstdint>
#include <vector>

#include "frontier_pilot/core/grid.h"

namespace frontier_pilot::test {

/// How well a map shows the true world: the share of the reachable floor that it shows as free, and the share of its
/// occupied cells that are not near a true wall. Reachable floor: the free cells that a disc covers, moving from the
/// start, but for those within 0.05 m of a wall: where the cells of the map and of the truth do not coincide, they say
/// how the two lie to each other and not whether the floor was seen.
class ExplorationMeter {
 public:
  /// `truth` is in the world's frame, and `T_world_map` is the pose of the map's frame in it, which is the start.
  /// Throws std::invalid_argument when the disc of `radius` [m] does not fit there.
  ExplorationMeter(const OccupancyGrid& truth, const Pose2& T_world_map, double radius);

  /// Share in [0, 1] of the reachable floor that `map` shows as free.
  double explored(const OccupancyGrid& map);
  /// Share in [0, 1] of the occupied cells of `map` that lie more than 0.25 m from everything that is not free in
  /// truth.
  double wrong(const OccupancyGrid& map) const;
  /// The area of the reachable floor [m^2].
  double area() const;
  /// Non-zero on the reachable floor, on the truth's grid.
  const Grid<std::uint8_t>& floor() const { return floor_; }

 private:
  void locate(const GridGeometry& map);

  Grid<std::uint8_t> floor_;
  Grid<std::uint8_t> near_wall_;
  Pose2 T_world_map_;
  std::vector<Vec2> targets_;              ///< centres of the floor's cells, in the map's frame
  GridGeometry located_;                   ///< the geometry for which the indices below hold
  std::vector<std::int64_t> target_cell_;  ///< index of the map's cell that holds each target, -1 outside
};

}  // namespace frontier_pilot::test
