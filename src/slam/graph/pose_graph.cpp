#include "slam/graph/pose_graph.h"

#include <algorithm>

#include "slam/graph/normal_equations.h"

namespace frontier_pilot::slam {
namespace {

double chi2Of(const PoseConstraint& constraint, const std::vector<Pose2>& poses) {
  const Eigen::Vector3d error = residual(constraint, poses[constraint.from], poses[constraint.to]);
  return error.dot(constraint.information * error);
}

std::vector<NodePair> pairsOf(const std::vector<PoseConstraint>& constraints) {
  std::vector<NodePair> pairs;
  pairs.reserve(constraints.size());
  for (const PoseConstraint& constraint : constraints) pairs.push_back({constraint.from, constraint.to});
  return pairs;
}

std::vector<Pose2> moved(std::vector<Pose2> poses, const Eigen::VectorXd& step) {
  for (std::size_t node = 1; node < poses.size(); ++node) {
    const Eigen::Vector3d d = step.segment<3>(3 * (static_cast<Eigen::Index>(node) - 1));
    Pose2& pose = poses[node];
    pose = {pose.x + d.x(), pose.y + d.y(), normalizeAngle(pose.yaw + d.z())};
  }
  return poses;
}

}  // namespace

Eigen::Vector3d residual(const PoseConstraint& constraint, const Pose2& T_map_from, const Pose2& T_map_to) {
  const Pose2 T_from_to = T_map_from.inverse() * T_map_to;
  const Pose2& measured = constraint.T_from_to;
  return {T_from_to.x - measured.x, T_from_to.y - measured.y, angleDifference(T_from_to.yaw, measured.yaw)};
}

ResidualJacobians residualJacobians(const Pose2& T_map_from, const Pose2& T_map_to) {
  const Vec2 seen = T_map_from.inverse() * T_map_to.position();
  ResidualJacobians jacobians;
  jacobians.by_to.setIdentity();
  jacobians.by_to.topLeftCorner<2, 2>() = Rotation2(T_map_from.yaw).matrix().transpose();
  jacobians.by_from = -jacobians.by_to;
  jacobians.by_from(0, 2) = seen.y();
  jacobians.by_from(1, 2) = -seen.x();
  return jacobians;
}

/// One optimisation: Levenberg-Marquardt steps during which the loss changes from convex to robust.
class PoseGraph::Problem {
 public:
  explicit Problem(PoseGraph& graph)
      : graph_(graph), equations_(graph.poses_.size(), pairsOf(graph.constraints_)), scale_(convexScale()) {}

  PoseGraphReport solve() {
    PoseGraphReport report;
    report.cost_before = cost(graph_.poses_);
    report.converged = false;
    while (!report.converged && report.iterations < graph_.parameters_.max_iterations) {
      ++report.iterations;
      const bool robust = scale_ <= 1.0;
      report.converged = !step() && robust;
      scale_ = std::max(1.0, scale_ / kScaleStep);
    }
    report.cost_after = cost(graph_.poses_);
    return report;
  }

 private:
  static constexpr double kScaleStep = 2.0;
  static constexpr double kMaxDamping = 1e8;
  static constexpr double kNothing = 1e-12;  // far below any error that matters

  /// The scale at which the loss is convex at the present errors of all robust constraints.
  double convexScale() const {
    double largest = 0.0;
    for (const PoseConstraint& constraint : graph_.constraints_) {
      if (constraint.robust) largest = std::max(largest, chi2Of(constraint, graph_.poses_));
    }
    return std::max(1.0, 3.0 * largest / graph_.parameters_.outlier_chi2);
  }

  double threshold() const { return scale_ * graph_.parameters_.outlier_chi2; }

  double cost(const std::vector<Pose2>& poses) const {
    double sum = 0.0;
    for (const PoseConstraint& constraint : graph_.constraints_) {
      const double chi2 = chi2Of(constraint, poses);
      sum += constraint.robust ? threshold() * chi2 / (threshold() + chi2) : chi2;
    }
    return 0.5 * sum;
  }

  void linearize() {
    equations_.setZero();
    for (std::size_t i = 0; i < graph_.constraints_.size(); ++i) {
      const PoseConstraint& constraint = graph_.constraints_[i];
      const Pose2& from = graph_.poses_[constraint.from];
      const Pose2& to = graph_.poses_[constraint.to];
      const Eigen::Vector3d error = residual(constraint, from, to);
      const ResidualJacobians jacobians = residualJacobians(from, to);
      equations_.add(i, error, jacobians.by_from, jacobians.by_to, weight(constraint, error) * constraint.information);
    }
  }

  /// The derivative of the loss with respect to the squared error.
  double weight(const PoseConstraint& constraint, const Eigen::Vector3d& error) const {
    if (!constraint.robust) return 1.0;
    const double share = threshold() / (threshold() + error.dot(constraint.information * error));
    return share * share;
  }

  /// Takes one step that does not raise the cost. Returns false when there is nothing left to gain.
  bool step() {
    const double before = cost(graph_.poses_);
    linearize();
    Eigen::VectorXd x;
    for (; damping_ < kMaxDamping; damping_ *= 10.0) {
      if (!equations_.solve(damping_, x)) continue;
      std::vector<Pose2> poses = moved(graph_.poses_, x);
      const double after = cost(poses);
      if (after > before) continue;
      damping_ = std::max(damping_ / 10.0, 1e-9);
      graph_.poses_ = std::move(poses);
      return before - after > graph_.parameters_.tolerance * before + kNothing;
    }
    return false;
  }

  PoseGraph& graph_;
  NormalEquations equations_;
  double scale_;           ///< factor by which the threshold of the robust loss still exceeds its final value
  double damping_ = 1e-6;  ///< share of H's diagonal that is added to it
};

std::size_t PoseGraph::addNode(const Pose2& T_map_node) {
  poses_.push_back(T_map_node);
  return poses_.size() - 1;
}

double PoseGraph::chi2(const PoseConstraint& constraint) const { return chi2Of(constraint, poses_); }

PoseGraphReport PoseGraph::optimize() {
  if (poses_.size() < 2 || constraints_.empty()) return {};
  return Problem(*this).solve();
}

}  // namespace frontier_pilot::slam
