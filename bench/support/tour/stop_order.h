#pragma once

#include <vector>

#include "support/tour/waypoint_graph.h"

namespace frontier_pilot::bench {

/// Shortens the way through `stops` by 2-opt and Or-opt until neither gains anything. The first stop stays the first;
/// the last one is free.
void improveOrder(const WaypointGraph& graph, std::vector<int>& stops);

}  // namespace frontier_pilot::bench
