#pragma once

#include <frontier_pilot/SetBounds.h>
#include <geometry_msgs/Polygon.h>

#include <vector>

#include "frontier_pilot/exploration/parameters.h"

namespace frontier_pilot {

/// The bounds of a request, unchecked.
exploration::ExplorationBounds toBounds(const SetBounds::Request& request);
geometry_msgs::Polygon toPolygonMsg(const std::vector<Vec2>& corners);

}  // namespace frontier_pilot
