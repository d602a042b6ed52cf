#pragma once

#include <iosfwd>
#include <vector>

#include "frontier_pilot/core/motion.h"

namespace frontier_pilot::logs {

/// Where something was, in the order of the stamps.
using Trajectory = std::vector<StampedPose2>;

/// Writes lines `stamp x y z qx qy qz qw` [s, m], as the tools around the TUM RGB-D benchmark read them. Whether it
/// could is left in the stream.
void writeTum(std::ostream& out, const Trajectory& trajectory);

}  // namespace frontier_pilot::logs
