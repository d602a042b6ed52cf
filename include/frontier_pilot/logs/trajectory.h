#pragma once

#include <iosfwd>
#include <vector>

#include "frontier_pilot/core/geometry.h"
#include "frontier_pilot/core/time.h"

namespace frontier_pilot::logs {

/// A pose and the time at which it was taken.
struct TrajectoryPose {
  Time stamp;
  Pose2 pose;
};
using Trajectory = std::vector<TrajectoryPose>;

/// Writes lines `stamp x y z qx qy qz qw` [s, m], the format of the TUM RGB-D benchmark and its tools. Check the stream
/// for errors afterwards.
void writeTum(std::ostream& out, const Trajectory& trajectory);

}  // namespace frontier_pilot::logs
