#pragma once

#include <cstdint>
#include <vector>

#include "exploration/frontier_search.h"

namespace frontier_pilot::exploration::detail {

/// For each run (sorted by row, then column) the index of the first run in its 8-connected component.
std::vector<std::uint32_t> labelRuns(const std::vector<FrontierRun>& runs);

/// Sorts labelled runs into clusters, drops the small components and cuts the long ones. Stops early and sets
/// `too_many` if there are too many clusters.
FrontierClusters collectClusters(const std::vector<FrontierRun>& runs, const std::vector<std::uint32_t>& labels,
                                 int min_cells, int max_extent);

}  // namespace frontier_pilot::exploration::detail
