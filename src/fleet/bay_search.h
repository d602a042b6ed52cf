#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "frontier_pilot/core/geometry.h"
#include "frontier_pilot/core/grid.h"

namespace frontier_pilot::fleet {

/// A way of another robot and how far away from it [m] one has to be.
struct KeepOff {
  std::vector<Vec2> line;
  double apart = 0.0;
};

/// The nearest place, by the length of the way there, where a robot of this radius [m] is off the `kMostBayLines` ways
/// of `off` that come nearest to it, without driving through the discs `bodies`, which are lines of one point. Cells
/// that are not known to be free are not entered. Places are looked at `kBaySpacing` apart, or a cell if that is more.
/// Nothing if there is none within `kBayReach` and among the nearest `kMostBayPlaces`. In the frame of the map.
constexpr double kBayReach = 15.0;    // [m]
constexpr double kBaySpacing = 0.05;  // [m]
constexpr std::size_t kMostBayPlaces = 40'000;
constexpr std::size_t kMostBayLines = 20;
std::optional<Vec2> findBay(const OccupancyGrid& map, const Vec2& from, double radius, const std::vector<KeepOff>& off,
                            const std::vector<KeepOff>& bodies);

}  // namespace frontier_pilot::fleet
