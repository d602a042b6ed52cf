#include "slam/graph/normal_equations.h"

#include <algorithm>
#include <utility>

namespace frontier_pilot::slam {
namespace {

using Index = Eigen::Index;
/// Column and row of the first element of a block in the lower triangle; compares by columns.
using Place = std::pair<Index, Index>;

Index rowOf(std::size_t node) { return 3 * (static_cast<Index>(node) - 1); }

/// The blocks of the lower triangle, as (column, row), sorted.
std::vector<Place> placesOf(std::size_t nodes, const std::vector<NodePair>& pairs) {
  std::vector<Place> places;
  places.reserve(nodes + pairs.size());
  for (std::size_t node = 1; node < nodes; ++node) places.emplace_back(rowOf(node), rowOf(node));
  for (const NodePair& pair : pairs) {
    const auto [low, high] = std::minmax(pair.first, pair.second);
    if (low > 0) places.emplace_back(rowOf(low), rowOf(high));
  }
  std::sort(places.begin(), places.end());
  places.erase(std::unique(places.begin(), places.end()), places.end());
  return places;
}

}  // namespace

NormalEquations::NormalEquations(std::size_t nodes, const std::vector<NodePair>& pairs)
    : hessian_(rowOf(nodes), rowOf(nodes)), gradient_(Eigen::VectorXd::Zero(rowOf(nodes))) {
  const std::vector<Place> places = placesOf(nodes, pairs);
  hessian_.resizeNonZeros(static_cast<Index>(9 * places.size()));
  int* starts = hessian_.outerIndexPtr();
  int* rows = hessian_.innerIndexPtr();
  int next = 0;
  for (auto column = places.begin(); column != places.end();) {
    const auto end = std::find_if(column, places.end(), [&](const Place& p) { return p.first != column->first; });
    for (Index j = column->first; j < column->first + 3; ++j) {
      starts[j] = next;
      for (auto block = column; block != end; ++block) {
        for (Index i = 0; i < 3; ++i) rows[next++] = static_cast<int>(block->second + i);
      }
    }
    column = end;
  }
  starts[hessian_.outerSize()] = next;
  setZero();
  layOut(pairs);
  cholesky_.analyzePattern(hessian_);
}

void NormalEquations::layOut(const std::vector<NodePair>& pairs) {
  slots_.reserve(pairs.size());
  for (const NodePair& pair : pairs) {
    Slots slots;
    if (pair.first > 0) slots.first = find(slots.row_first = rowOf(pair.first), rowOf(pair.first));
    if (pair.second > 0) slots.second = find(slots.row_second = rowOf(pair.second), rowOf(pair.second));
    if (pair.first > 0 && pair.second > 0) {
      slots.cross = find(std::max(slots.row_first, slots.row_second), std::min(slots.row_first, slots.row_second));
    }
    slots_.push_back(slots);
  }
}

NormalEquations::Block NormalEquations::find(Index row, Index column) const {
  const int* starts = hessian_.outerIndexPtr();
  const int* rows = hessian_.innerIndexPtr();
  const int* place = std::lower_bound(rows + starts[column], rows + starts[column + 1], static_cast<int>(row));
  const Index height = starts[column + 1] - starts[column];
  const Index first = place - rows;
  return {first, first + height, first + 2 * height};
}

void NormalEquations::setZero() {
  std::fill_n(hessian_.valuePtr(), hessian_.nonZeros(), 0.0);
  gradient_.setZero();
}

void NormalEquations::addBlock(const Block& block, const Eigen::Matrix3d& value) {
  for (Index column = 0; column < 3; ++column) {
    double* values = hessian_.valuePtr() + block[static_cast<std::size_t>(column)];
    for (Index row = 0; row < 3; ++row) values[row] += value(row, column);
  }
}

void NormalEquations::add(std::size_t index, const Eigen::Vector3d& error, const Jacobian& by_first,
                          const Jacobian& by_second, const Eigen::Matrix3d& information) {
  const Slots& slots = slots_[index];
  const Eigen::Matrix3d weighted_first = by_first.transpose() * information;
  const Eigen::Matrix3d weighted_second = by_second.transpose() * information;
  if (slots.row_first >= 0) {
    addBlock(slots.first, weighted_first * by_first);
    gradient_.segment<3>(slots.row_first) += weighted_first * error;
  }
  if (slots.row_second >= 0) {
    addBlock(slots.second, weighted_second * by_second);
    gradient_.segment<3>(slots.row_second) += weighted_second * error;
  }
  if (slots.row_first < 0 || slots.row_second < 0) return;
  const bool second_is_lower = slots.row_second > slots.row_first;
  addBlock(slots.cross,
           second_is_lower ? Eigen::Matrix3d(weighted_second * by_first) : Eigen::Matrix3d(weighted_first * by_second));
}

bool NormalEquations::solve(double damping, Eigen::VectorXd& x) {
  // The offset keeps H regular if there is a node without constraints: that has no gradient, and stays.
  constexpr double kOffset = 1e-9;
  cholesky_.setShift(kOffset, 1.0 + damping);
  cholesky_.factorize(hessian_);
  if (cholesky_.info() != Eigen::Success) return false;
  x = cholesky_.solve(-gradient_);
  return x.allFinite();
}

}  // namespace frontier_pilot::slam
