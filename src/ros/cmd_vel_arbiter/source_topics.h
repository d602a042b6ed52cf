#pragma once

#include <ros/node_handle.h>

#include "frontier_pilot/arbiter/parameters.h"

namespace frontier_pilot {

/// The parameters of an arbiter, with the names of its sources' topics checked as they resolve: two sources on one
/// topic, or one on the arbiter's own output, may be spelled differently or remapped. Throws a ConfigurationError that
/// names every problem.
arbiter::ArbiterParameters loadArbiterParameters(const ros::NodeHandle& node, const ros::NodeHandle& private_node);

}  // namespace frontier_pilot
