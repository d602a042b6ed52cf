#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "frontier_pilot/core/geometry.h"
#include "frontier_pilot/core/grid.h"
#include "frontier_pilot/surfaces/surface_points.h"

namespace frontier_pilot::fleet {

/// A part of a map, some metres wide, that is searched for in another map.
struct MapWindow {
  Cell cell;    ///< of the lattice of windows, which is fixed in the map's frame
  Vec2 centre;  ///< [m], map frame

  /// The points of `surface` in the window, thinned, and in a frame at its centre.
  surfaces::SurfacePoints pointsOf(const surfaces::SurfacePoints& surface) const;
};

/// Windows that cover the walls of a map, ordered by their cells.
std::vector<MapWindow> windowsOf(const surfaces::SurfacePoints& surface);

/// Which windows of a map `b` are searched for next in a map `a`, while both maps grow.
struct WindowRound {
  std::size_t most = 0;              ///< windows of one search
  std::optional<Cell> after;         ///< the cell of the window that was the last one; none at the beginning
  std::optional<Pose2> T_a_b_guess;  ///< a place that has been found once

  /// Up to `most` of `windows`, beginning behind the last one, in a circle. With a guess, half of them are such that
  /// `a` knows the place if the guess is right; so it is soon confirmed, and others are found all the same.
  std::vector<MapWindow> next(const std::vector<MapWindow>& windows,
                              const std::function<bool(const Vec2& in_a)>& is_known);
};

}  // namespace frontier_pilot::fleet
