#pragma once

#include <string>
#include <vector>

#include "frontier_pilot/core/grid.h"

namespace frontier_pilot::bench {

/// A line over a map, coloured from its first point (blue) to its last (red). Points in the map's frame [m].
struct SvgTrack {
  std::vector<Vec2> points;
};

/// An SVG drawing of `map` with the tracks on top of it, 10 user units per metre. Unknown is grey, floor white.
std::string drawSvg(const OccupancyGrid& map, const std::vector<SvgTrack>& tracks, const std::string& caption);

}  // namespace frontier_pilot::bench
