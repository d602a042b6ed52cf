#pragma once

#include <visualization_msgs/MarkerArray.h>

#include <string>
#include <vector>

#include "frontier_pilot/core/time.h"
#include "frontier_pilot/exploration/explorer_types.h"
#include "frontier_pilot/exploration/frontier.h"
#include "frontier_pilot/exploration/parameters.h"

namespace frontier_pilot {

/// What rviz is shown of an exploration.
struct ExplorerScene {
  const std::vector<exploration::Frontier>& frontiers;
  const GridGeometry& geometry;  ///< what `Frontier::cells` refer to
  const std::vector<exploration::BlacklistedPlace>& blacklist;
  const exploration::ExplorationBounds& bounds;
  const std::vector<Vec2>& tour;
  const std::vector<Vec2>& clicked;      ///< corners of bounds that are being drawn
  const std::vector<Pose2> inspections;  ///< poses that wait to be inspected
  const std::string owner;               ///< namespace of the robot; "/" if it has none
};

/// The markers of an exploration for rviz, each kind in a namespace of its own: the `cells` and `centroids` of
/// selectable frontiers (spheres that grow with the expected information), their `scores`, which on a tour are the
/// place in it and the time until then, after the robot's namespace, the `tour` as a line through its stops,
/// blacklisted places in red, and the rejected frontiers in grey, with the reason in the namespace (`rejected: too
/// near`) and as text. Frontiers that are too small, left out or in small corners, of which there can be many, have no
/// text. `bounds` and `keep out` are the sides of the polygons, `new bounds` the corners of a polygon that is being
/// clicked, and `to inspect` arrows at the poses to take on the way.
visualization_msgs::MarkerArray makeExplorerMarkers(const ExplorerScene& scene, const std::string& frame, Time stamp);

}  // namespace frontier_pilot
