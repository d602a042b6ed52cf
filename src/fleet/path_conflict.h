#pragma once

#include <optional>
#include <vector>

#include "frontier_pilot/core/geometry.h"
#include "frontier_pilot/core/grid.h"

namespace frontier_pilot::fleet {

/// The distance from `point` to the polyline [m]; a single point is one, too. It must not be empty.
double distanceTo(const std::vector<Vec2>& line, const Vec2& point);

/// The same line with points at most `spacing` [m] apart, of its first `reach` metres.
std::vector<Vec2> resampled(const std::vector<Vec2>& line, double spacing, double reach);

/// What is left of the line for a robot at `position`: that, and the line from where it comes nearest.
std::vector<Vec2> remaining(const std::vector<Vec2>& line, const Vec2& position);

/// Where two ways lead over the same ground on which there is no room for both robots side by side; lengths along each
/// robot's way, from where it is [m].
struct PathConflict {
  double own_entry = 0.0;   ///< where that ground begins
  double own_exit = 0.0;    ///< where this robot's way becomes wide again behind it
  double other_exit = 0.0;  ///< the same of the other one
};

/// The room that both robots need.
struct PassingRoom {
  double apart = 0.0;  ///< least distance of their centres [m]
  double width = 0.0;  ///< least width of a place where they can pass each other [m]
};

/// The first narrow stretch that both ways share, unless they lead through it in the same direction; nothing if there
/// is none within `kConflictReach`. A way of a single point belongs to a robot that stands. Unknown cells count as
/// room.
constexpr double kConflictReach = 15.0;  // [m]
std::optional<PathConflict> findConflict(const std::vector<Vec2>& own, const std::vector<Vec2>& other,
                                         const PassingRoom& room, const OccupancyGrid& map);

}  // namespace frontier_pilot::fleet
