#pragma once

#include <iosfwd>
#include <vector>

#include "frontier_pilot/core/motion.h"

namespace frontier_pilot::logs {

/// Poses in the order of their stamps.
using Trajectory = std::vector<StampedPose2>;

/// Writes lines `stamp x y z qx qy qz qw` [s, m], the format of the TUM RGB-D benchmark and its tools. Check the stream
/// for errors afterwards.
void writeTum(std::ostream& out, const Trajectory& trajectory);

}  // namespace frontier_pilot::logs
