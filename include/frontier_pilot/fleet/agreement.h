#pragma once

#include <cstddef>

#include "frontier_pilot/core/geometry.h"
#include "frontier_pilot/core/grid.h"

namespace frontier_pilot::fleet {

/// How well two maps agree where both know something, under an assumed transform between their frames. Sums over
/// several maps are meaningful.
struct Agreement {
  double overlap = 0.0;          ///< area that both know [m^2]
  std::size_t known = 0;         ///< cells that both know
  std::size_t agreeing = 0;      ///< of these, cells that are free in both or occupied in both
  std::size_t walls = 0;         ///< occupied cells of either map that the other one knows
  std::size_t contradicted = 0;  ///< of these, cells where the other map knows free space for MergedMap::kClearance

  /// Share of the cells that both know that agree; 1 without any.
  double agreeingShare() const;
  /// Share of the walls that the other map contradicts; 0 while there are so few that they say nothing: where robots
  /// saw each other, each leaves some tens of cells that the other contradicts.
  double contradictedShare() const;
  Agreement& operator+=(const Agreement& other);
};

/// Compares each cell of `b` with the cell of `a` in which its centre lies, and the other way round for walls. A wrong
/// transform puts walls of one map into the free space of the other. [MUL-1]
Agreement compare(const OccupancyGrid& a, const OccupancyGrid& b, const Pose2& T_a_b);

}  // namespace frontier_pilot::fleet
