#pragma once

#include <visualization_msgs/MarkerArray.h>

#include <string>
#include <vector>

#include "frontier_pilot/core/time.h"
#include "frontier_pilot/exploration/explorer_types.h"
#include "frontier_pilot/exploration/frontier.h"

namespace frontier_pilot {

/// What rviz shows of an exploration, each kind in a namespace of its own: the `cells` and `centroids` of selectable
/// frontiers (a sphere as large as the information is), their `scores`, blacklisted places in red, and the rejected
/// frontiers in grey, by reason (`rejected: too near`), each with its reason as text. The too small and the left
/// out ones, of which there can be thousands, carry it in the namespace alone.
visualization_msgs::MarkerArray makeExplorerMarkers(const std::vector<exploration::Frontier>& frontiers,
                                                    const std::vector<exploration::BlacklistedPlace>& blacklist,
                                                    const GridGeometry& geometry, const std::string& frame, Time stamp);

}  // namespace frontier_pilot
