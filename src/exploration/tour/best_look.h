#pragma once

#include <vector>

#include "exploration/tour/frontier_views.h"
#include "frontier_pilot/exploration/parameters.h"

namespace frontier_pilot::exploration {

/// Which way a robot has to look at a place.
struct Look {
  double yaw = 0.0;    ///< [rad]
  double slack = kPi;  ///< how far its yaw may be from that [rad]; pi if its scanner sees all around
};

/// The yaw with which the robot's scanner sees most of a view in its field of view.
Look bestLook(const std::vector<Glimpse>& glimpses, const ViewParameters& parameters);

/// The yaw nearest to `wanted` that `look` allows [rad].
double nearestYaw(const Look& look, double wanted);

}  // namespace frontier_pilot::exploration
