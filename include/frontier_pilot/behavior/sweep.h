#pragma once

#include "frontier_pilot/core/grid.h"
#include "frontier_pilot/core/outline.h"

namespace frontier_pilot::behavior {

/// A motion along one axis of the base: a turn in place or a straight line, with its sign.
struct AxisMotion {
  enum class Axis { kTurn, kLine };
  Axis axis = Axis::kTurn;
  double amount = 0.0;  ///< [rad] counter-clockwise, or [m] forward

  /// The pose of a base that started at the origin when `share` (0...1) of the motion is done.
  Pose2 at(double share) const {
    return axis == Axis::kTurn ? Pose2(0.0, 0.0, share * amount) : Pose2(share * amount, 0.0, 0.0);
  }
};

/// The first thing that a look along a motion has met.
enum class SweepResult {
  kClear,
  kObstacle,
  kUnseen,     ///< a cell that no scan has seen
  kOffGrid,    ///< the costmap ends there
  kNoCostmap,  ///< there is none, or its last scan is too old
};
const char* toString(SweepResult result);

/// Whether the footprint stays on free cells of `grid` during all of `motion` from `pose`, both ends included; between
/// checked poses its farthest corner moves by at most half a cell. On a line, an obstacle that lies under the trailing
/// half of the footprint at the start does not count, because the robot moves away from it. [SPN-2] [SPN-3]
SweepResult sweep(const OccupancyGrid& grid, const Outline& footprint, const Pose2& pose, const AxisMotion& motion);

}  // namespace frontier_pilot::behavior
