#pragma once

#include <cstddef>
#include <istream>
#include <string>
#include <vector>

#include "frontier_pilot/logs/trajectory.h"

namespace frontier_pilot::logs {

/// A reference measurement: where the base was at record `to`, seen from where it was at record `from`.
struct PoseRelation {
  std::size_t from = 0;
  std::size_t to = 0;
  Pose2 T_from_to;
};

/// Reads lines `i j dx [m] dy [m] dyaw [rad]`. Empty lines and those that begin with # are passed over. Throws a
/// LogError naming `name` and the line where it is broken or names a record that a log of `records` does not have.
std::vector<PoseRelation> readRelations(std::istream& file, const std::string& name, std::size_t records);

/// Mean and standard deviation.
struct Spread {
  double mean = 0.0;
  double stddev = 0.0;
};

/// How far a trajectory is from relations: of the lengths [m] and the angles [rad] of the differences.
struct RelationError {
  Spread translation;
  Spread rotation;
};

/// Kuemmerle et al., "On measuring the accuracy of SLAM algorithms", Autonomous Robots 27, 2009, eq. 5, with absolute
/// values. All zero without relations.
RelationError relationError(const std::vector<Pose2>& trajectory, const std::vector<PoseRelation>& relations);

/// The root of the mean square of position [m] and yaw [rad] errors, and the largest of each.
struct AbsoluteError {
  double position_rmse = 0.0;
  double yaw_rmse = 0.0;
  double position_max = 0.0;
  double yaw_max = 0.0;
};

/// The absolute trajectory error (Sturm et al., "A Benchmark for the Evaluation of RGB-D SLAM Systems", IROS 2012),
/// but with the trajectories laid upon each other at their first pose. Both must be as long; all zero when empty.
AbsoluteError absoluteError(const std::vector<Pose2>& estimate, const std::vector<Pose2>& truth);

}  // namespace frontier_pilot::logs
