#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "frontier_pilot/core/geometry.h"
#include "frontier_pilot/slam/parameters.h"

namespace frontier_pilot::slam {

/// A measurement between two nodes of a pose graph: where `to` is, seen from `from`.
struct PoseConstraint {
  std::size_t from = 0;
  std::size_t to = 0;
  Pose2 T_from_to;
  Eigen::Matrix3d information = Eigen::Matrix3d::Identity();  ///< of x, y [m] and yaw [rad], along the axes of `from`
  bool robust = false;  ///< a robust kernel lowers its weight where the graph disagrees
};

/// x, y [m] and yaw [rad] of the constraint's `to`, seen from `from`, less what was measured.
Eigen::Vector3d residual(const PoseConstraint& constraint, const Pose2& T_map_from, const Pose2& T_map_to);

/// The derivatives of `residual` with respect to x, y [m] and yaw [rad] of either node's pose.
struct ResidualJacobians {
  Eigen::Matrix3d by_from;
  Eigen::Matrix3d by_to;
};
ResidualJacobians residualJacobians(const Pose2& T_map_from, const Pose2& T_map_to);

/// How an optimisation went. Costs are half the weighted sum of squared errors.
struct PoseGraphReport {
  int iterations = 0;
  double cost_before = 0.0;
  double cost_after = 0.0;
  bool converged = true;
};

/// Poses and measurements between them, optimised so that the poses explain the measurements best: nonlinear least
/// squares by Levenberg-Marquardt with a sparse Cholesky factorisation. Plain data: a copy is an independent graph.
/// The same graph gives the same poses, bit by bit.
/// Grisetti, Kuemmerle, Stachniss & Burgard, "A Tutorial on Graph-Based SLAM", IEEE ITS Magazine 2(4), 2010.
/// Robustly weighted constraints have the loss of Geman & McClure (related to that of Agarwal et al., "Robust Map
/// Optimization using Dynamic Covariance Scaling", ICRA 2013), reached from plain least squares by graduated
/// non-convexity, so that a true closure of a long loop, whose error is large at first, is not rejected as an outlier:
/// Yang, Antonante, Tzoumas & Carlone, RA-L 5(2), 2020.
class PoseGraph {
 public:
  explicit PoseGraph(const PoseGraphParameters& parameters = {}) : parameters_(parameters) {}

  /// Returns the node's index; the first node is 0, and it never moves.
  std::size_t addNode(const Pose2& T_map_node);
  /// Both nodes must exist and differ, and the information be symmetric and positive semidefinite.
  void addConstraint(const PoseConstraint& constraint) { constraints_.push_back(constraint); }

  std::size_t size() const { return poses_.size(); }
  const Pose2& pose(std::size_t node) const { return poses_[node]; }
  const std::vector<Pose2>& poses() const { return poses_; }
  void setPose(std::size_t node, const Pose2& T_map_node) { poses_[node] = T_map_node; }
  const std::vector<PoseConstraint>& constraints() const { return constraints_; }
  const PoseGraphParameters& parameters() const { return parameters_; }

  /// The squared Mahalanobis error of a constraint at the present poses.
  double chi2(const PoseConstraint& constraint) const;

  /// Moves the nodes to where the constraints are met best. Nodes that no constraint holds stay.
  PoseGraphReport optimize();

 private:
  class Problem;

  PoseGraphParameters parameters_;
  std::vector<Pose2> poses_;
  std::vector<PoseConstraint> constraints_;
};

}  // namespace frontier_pilot::slam
