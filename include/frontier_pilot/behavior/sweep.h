#pragma once

#include "frontier_pilot/core/grid.h"
#include "frontier_pilot/core/outline.h"

namespace frontier_pilot::behavior {

/// A motion along one axis of the base: a turn in place or a straight line, with its sign.
struct AxisMotion {
  enum class Axis { kTurn, kLine };
  Axis axis = Axis::kTurn;
  double amount = 0.0;  ///< [rad] counter-clockwise, or [m] forward

  /// Where a base at the origin is when `share` (0...1) of the motion is done.
  Pose2 at(double share) const {
    return axis == Axis::kTurn ? Pose2(0.0, 0.0, share * amount) : Pose2(share * amount, 0.0, 0.0);
  }
};

/// What a look along a motion found first.
enum class SweepResult {
  kClear,
  kObstacle,
  kUnseen,     ///< a cell that no scan has seen
  kOffGrid,    ///< the costmap ends there
  kNoCostmap,  ///< there is none, or its last scan is too old
};
const char* toString(SweepResult result);

/// Whether the footprint can do all of `motion` from `pose` over free cells of `grid`, both ends included; poses lie at
/// most half a cell apart at the farthest corner. On a line, an obstacle under the trailing half of the footprint at
/// the start is left behind rather than run into and does not count: a robot that touches something may back away from
/// it. [SPN-2] [SPN-3]
SweepResult sweep(const OccupancyGrid& grid, const Outline& footprint, const Pose2& pose, const AxisMotion& motion);

}  // namespace frontier_pilot::behavior
