#pragma once

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <array>
#include <cstddef>
#include <vector>

namespace frontier_pilot::slam {

/// Two nodes that a measurement connects.
struct NodePair {
  std::size_t first = 0;
  std::size_t second = 0;
};

/// The normal equations H x = -b of a pose graph: symmetric, sparse, in blocks of 3 x 3. The sparsity pattern
/// of H is determined once, and each linearisation only sums up values. Node 0 is the gauge and has no row.
class NormalEquations {
 public:
  using Jacobian = Eigen::Matrix3d;

  /// `nodes` >= 2 with node 0; one pair for each measurement, in their order.
  NormalEquations(std::size_t nodes, const std::vector<NodePair>& pairs);

  void setZero();
  /// Adds measurement `index`: its error, the Jacobians of that by its two nodes, and its information.
  void add(std::size_t index, const Eigen::Vector3d& error, const Jacobian& by_first, const Jacobian& by_second,
           const Eigen::Matrix3d& information);
  /// Solves (H + damping diag H) x = -b for the nodes 1, 2, ... False when H cannot be factorised.
  bool solve(double damping, Eigen::VectorXd& x);

 private:
  using Matrix = Eigen::SparseMatrix<double>;
  /// Indices among the matrix's values at which the columns of a block begin.
  using Block = std::array<Eigen::Index, 3>;
  struct Slots {
    Eigen::Index row_first = -1, row_second = -1;  ///< the nodes' rows; -1: the gauge
    Block first{}, second{}, cross{};
  };

  void layOut(const std::vector<NodePair>& pairs);
  Block find(Eigen::Index row, Eigen::Index column) const;
  void addBlock(const Block& block, const Eigen::Matrix3d& value);

  Matrix hessian_;  ///< its lower triangle, and all of the blocks on the diagonal
  Eigen::VectorXd gradient_;
  std::vector<Slots> slots_;
  Eigen::SimplicialLDLT<Matrix, Eigen::Lower> cholesky_;
};

}  // namespace frontier_pilot::slam
