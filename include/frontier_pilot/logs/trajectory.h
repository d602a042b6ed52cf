#pragma once

#include <cstddef>
#include <iosfwd>
#include <string>
#include <vector>

#include "frontier_pilot/core/geometry.h"
#include "frontier_pilot/core/motion.h"

namespace frontier_pilot::logs {

/// Poses in the order of their stamps.
using Trajectory = std::vector<StampedPose2>;

/// Writes lines `stamp x y z qx qy qz qw` [s, m], the format of the TUM RGB-D benchmark and its tools. Check the stream
/// for errors afterwards.
void writeTum(std::ostream& out, const Trajectory& trajectory);

/// A reference measurement: the pose of the base at record `to` in the frame of the base at record `from`.
struct PoseRelation {
  std::size_t from = 0;
  std::size_t to = 0;
  Pose2 T_from_to;
};

/// Reads lines `i j dx [m] dy [m] dyaw [rad]`. Empty lines and lines that begin with # are skipped. Throws a LogError
/// that names the file (`name`) and the line if it is malformed or refers to a record beyond the log's `records`.
std::vector<PoseRelation> readRelations(std::istream& file, const std::string& name, std::size_t records);

/// Mean and standard deviation.
struct Spread {
  double mean = 0.0;
  double stddev = 0.0;
};

/// How far a trajectory deviates from relations: statistics of the lengths [m] and angles [rad] of the differences.
struct RelationError {
  Spread translation;
  Spread rotation;
};

/// Kuemmerle et al., "On measuring the accuracy of SLAM algorithms", Autonomous Robots 27, 2009, eq. 5, with absolute
/// values. All zero without relations.
RelationError relationError(const std::vector<Pose2>& trajectory, const std::vector<PoseRelation>& relations);

/// Root mean square and maximum of the position errors [m] and of the yaw errors [rad].
struct AbsoluteError {
  double position_rmse = 0.0;
  double yaw_rmse = 0.0;
  double position_max = 0.0;
  double yaw_max = 0.0;
};

/// The absolute trajectory error (Sturm et al., "A Benchmark for the Evaluation of RGB-D SLAM Systems", IROS 2012),
/// but with the trajectories aligned at their first poses. Both must have the same length; all zero when empty.
AbsoluteError absoluteError(const std::vector<Pose2>& estimate, const std::vector<Pose2>& truth);

}  // namespace frontier_pilot::logs
