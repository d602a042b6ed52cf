#pragma once

#include <vector>

#include "support/tour/waypoint_graph.h"

namespace frontier_pilot::bench {

/// The additional length [m] when the way visits `node` before the stop number `before`, or last.
double detour(const WaypointGraph& graph, const std::vector<int>& stops, int node, std::size_t before);

/// Shortens the way through `stops` by 2-opt and Or-opt until neither gains anything. The first stop stays the first;
/// the last one is free.
void improveOrder(const WaypointGraph& graph, std::vector<int>& stops);

}  // namespace frontier_pilot::bench
