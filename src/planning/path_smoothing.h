#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "frontier_pilot/planning/clearance_map.h"
#include "frontier_pilot/planning/path.h"

namespace frontier_pilot::planning {

/// The cheapest polyline through some of `samples`, from the first to the last, by valid straight lines: string
/// pulling, with the nearness of walls priced in as the search did, so that the path does not hug the corners again.
/// The line between two successive samples must be valid. Each line leads at most `ahead` samples on. After the
/// post-smoothing of A* in Daniel, Nash, Koenig & Felner, "Theta*: Any-Angle Path Planning on Grids", JAIR 39, 2010,
/// but optimal over all pairs (dynamic programming) instead of greedy.
Path pullString(const ClearanceMap& map, const std::vector<Vec2>& samples,
                std::size_t ahead = std::numeric_limits<std::size_t>::max());

/// String pulling of a path whose every segment is valid, at finer and finer spacing around its corners, until it is
/// taut.
Path smoothPath(const ClearanceMap& map, const Path& path);

}  // namespace frontier_pilot::planning
