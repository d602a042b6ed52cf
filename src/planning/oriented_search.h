#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "frontier_pilot/planning/outline_check.h"

namespace frontier_pilot::planning {

/// A path of straight motions and turns on the spot for an outline that is not a disc, for when it cannot turn where
/// the shortest path for its lane requires it: A* (Hart, Nilsson & Raphael, 1968) over cells and sixteen directions,
/// those of a cell's neighbours and of the knight's moves between them, as in the state lattices of Pivtoraiko, Knepper
/// & Kelly (Journal of Field Robotics 26(3), 2009) without their curves. The heuristic is the cost to a goal by a
/// search over the cells alone. The robot never backs up.
class OrientedSearch {
 public:
  OrientedSearch(const ClearanceMap& map, const OutlineCheck& outline) : map_(map), outline_(outline) {}

  /// Corners (centres of cells) of a shortened path from `start` to the nearest of `goals`; empty if there is no path,
  /// or none within the limit of `most` expanded states. `robot` is the robot's pose, in `start`; without it the path
  /// may begin in any direction.
  std::vector<Vec2> search(Cell start, const std::optional<Pose2>& robot, const std::vector<Cell>& goals,
                           std::size_t most);
  /// Number of states that the last search expanded.
  std::size_t expanded() const { return expanded_; }

 private:
  const ClearanceMap& map_;
  const OutlineCheck& outline_;
  std::size_t expanded_ = 0;
};

}  // namespace frontier_pilot::planning
