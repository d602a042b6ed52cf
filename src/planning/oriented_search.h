#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "frontier_pilot/planning/outline_check.h"

namespace frontier_pilot::planning {

/// A path of straight motions and turns on the spot for an outline that is no disc, where the shortest one for its lane
/// leads it to where it cannot turn: A* (Hart, Nilsson & Raphael, 1968) over cells and sixteen directions, those of a
/// cell's neighbours and of the knight's moves between them, as in the state lattices of Pivtoraiko, Knepper & Kelly
/// (Journal of Field Robotics 26(3), 2009) without their curves. What is left to a goal is taken from a search over the
/// cells alone. The robot never backs up.
class OrientedSearch {
 public:
  OrientedSearch(const ClearanceMap& map, const OutlineCheck& outline) : map_(map), outline_(outline) {}

  /// Centres of cells from `start` to the nearest of `goals`, with the corners only, pulled taut; empty: there is no
  /// way, or none among the states that a search may look at. `robot` is where it is, in `start`; without it it
  /// may begin in any direction.
  std::vector<Vec2> search(Cell start, const std::optional<Pose2>& robot, const std::vector<Cell>& goals);
  /// How many states it looked at.
  std::size_t expanded() const { return expanded_; }

 private:
  const ClearanceMap& map_;
  const OutlineCheck& outline_;
  std::size_t expanded_ = 0;
};

}  // namespace frontier_pilot::planning
