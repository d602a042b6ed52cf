#pragma once

#include <iosfwd>
#include <vector>

#include "frontier_pilot/core/geometry.h"
#include "frontier_pilot/core/time.h"

namespace frontier_pilot::logs {

/// Where something was at a time.
struct TrajectoryPose {
  Time stamp;
  Pose2 pose;
};
using Trajectory = std::vector<TrajectoryPose>;

/// Writes lines `stamp x y z qx qy qz qw` [s, m], as the tools around the TUM RGB-D benchmark read them. Whether it
/// could is left in the stream.
void writeTum(std::ostream& out, const Trajectory& trajectory);

}  // namespace frontier_pilot::logs
