#pragma once

#include <array>
#include <cstdint>

#include "frontier_pilot/core/geometry.h"
#include "frontier_pilot/core/grid.h"
#include "frontier_pilot/surfaces/surface_points.h"

namespace frontier_pilot::fleet {

/// The walls of a map by the direction that they face, so that the two sides of a thin wall, which two robots may have
/// seen from different rooms, are not taken for each other.
class WallFaces {
 public:
  explicit WallFaces(const surfaces::SurfacePoints& surface);

  /// Moves `T_a_b` to where `points` (of b) lie on walls that face the same way: Gauss-Newton on 1 - likelihood, as in
  /// Kohlbrecher et al., "A Flexible and Scalable SLAM System with Full 3D Motion Estimation", SSRR 2011, here weighted
  /// by the likelihood, because many points of one map have no counterpart in the other.
  Pose2 climb(const surfaces::SurfacePoints& points, Pose2 T_a_b) const;

 private:
  std::array<Grid<std::uint8_t>, 4> likelihoods_;  ///< of walls that face in each of the directions of the axes
};

}  // namespace frontier_pilot::fleet
