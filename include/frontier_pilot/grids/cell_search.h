#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <limits>
#include <queue>
#include <tuple>
#include <vector>

#include "frontier_pilot/core/grid.h"

/// What searches over 8-connected cells have in common.
namespace frontier_pilot::grids {

/// The steps to a cell's neighbours, counter-clockwise from +x; the odd ones are diagonal.
inline constexpr std::array<Cell, 8> kNeighbourSteps{
    {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}}};

/// What each of these steps adds to a cell's index on a grid of `width` cells, modulo the range of the type.
inline std::array<std::size_t, 8> neighbourOffsets(int width) {
  std::array<std::size_t, 8> offsets{};
  for (std::size_t i = 0; i < offsets.size(); ++i) {
    offsets[i] = static_cast<std::size_t>(kNeighbourSteps[i].x + std::ptrdiff_t{kNeighbourSteps[i].y} * width);
  }
  return offsets;
}

/// A priority queue for integer keys: a ring of buckets (Dial, "Algorithm 360", CACM 12(11), 1969). All keys in it lie
/// less than `kBuckets` above the least one, and none is pushed that is less than the last one taken.
template <std::uint32_t kBuckets>
class BucketQueue {
 public:
  /// Empties it; no key will be less than `least`.
  void reset(std::uint32_t least) {
    if (size_ != 0) {
      for (auto& bucket : buckets_) bucket.clear();
    }
    size_ = 0;
    least_ = least;
  }
  bool empty() const { return size_ == 0; }
  void push(std::uint32_t value, std::uint32_t key) {
    buckets_[key % kBuckets].push_back(value);
    ++size_;
  }
  /// Takes one of the least key, the last one pushed of these. Must not be empty.
  std::uint32_t pop() {
    std::vector<std::uint32_t>& bucket = leastBucket();
    const std::uint32_t value = bucket.back();
    bucket.pop_back();
    --size_;
    return value;
  }
  /// Takes all of the least key, in the order in which they were pushed: `visit(value, key)` may push greater keys,
  /// less than `kBuckets` greater. Must not be empty.
  template <class Visit>
  void popLeast(Visit visit) {
    const std::vector<std::uint32_t>& bucket = leastBucket();
    for (const std::uint32_t value : bucket) visit(value, least_);
    size_ -= bucket.size();
    buckets_[least_ % kBuckets].clear();
  }

 private:
  std::vector<std::uint32_t>& leastBucket() {
    while (buckets_[least_ % kBuckets].empty()) ++least_;
    return buckets_[least_ % kBuckets];
  }

  std::array<std::vector<std::uint32_t>, kBuckets> buckets_;
  std::uint32_t least_ = 0;
  std::size_t size_ = 0;
};

/// One value per cell of the square that extends `reach` cells to every side of `centre`: storage for a search that
/// stays near a cell. Cells have their indices on the underlying grid. Access outside of the square is undefined.
template <class T>
class CellWindow {
 public:
  CellWindow(Cell centre, int reach, T fill)
      : low_{centre.x - reach, centre.y - reach}, values_(square(2 * reach + 1), fill) {}

  T& operator[](Cell cell) { return values_[local(cell)]; }
  const T& operator[](Cell cell) const { return values_[local(cell)]; }

 private:
  static GridGeometry square(int side) {
    GridGeometry geometry;
    geometry.width = geometry.height = side;
    return geometry;
  }
  Cell local(Cell cell) const { return {cell.x - low_.x, cell.y - low_.y}; }

  Cell low_;
  Grid<T> values_;
};

/// The ways out of a place where the robot's centre may not be, because it stands too near an obstacle, to the nearest
/// cells where it may: Dijkstra's search (Numerische Mathematik 1, 1959) over the cells within `reach` cells of it.
class ExitSearch {
 public:
  ExitSearch(Cell from, int reach)
      : from_(from),
        reach_(reach),
        cost_(from, reach, std::numeric_limits<double>::infinity()),
        parent_(from, reach, from) {}

  /// `isExit(cell)`: the centre may be there. `stepCost(cell, next)` >= 0 of a step between neighbours, negative where
  /// there is none. `found(cell, cost)` is called for each exit, the cheapest first, of equal ones in the order of rows
  /// and columns. The search goes on through exits only with `beyond`.
  template <class IsExit, class StepCost, class Found>
  void run(bool beyond, IsExit isExit, StepCost stepCost, Found found) {
    push(from_, from_, 0.0);
    while (!queue_.empty()) {
      const auto [cost, y, x] = queue_.top();
      const Cell cell{x, y};
      queue_.pop();
      if (cost > cost_[cell]) continue;
      const bool out = isExit(cell);
      if (out) found(cell, cost);
      if (out && !beyond) continue;
      for (const Cell step : kNeighbourSteps) {
        const Cell next{cell.x + step.x, cell.y + step.y};
        if (std::abs(next.x - from_.x) > reach_ || std::abs(next.y - from_.y) > reach_) continue;
        const double price = stepCost(cell, next);
        if (price >= 0.0) push(next, cell, cost + price);
      }
    }
  }
  /// The cells from the first one to `cell`, which the search must have come to.
  std::vector<Cell> wayTo(Cell cell) const {
    std::vector<Cell> way{cell};
    while (way.back() != from_) way.push_back(parent_[way.back()]);
    return {way.rbegin(), way.rend()};
  }

 private:
  using Open = std::tuple<double, int, int>;

  void push(Cell cell, Cell parent, double cost) {
    if (cost >= cost_[cell]) return;
    cost_[cell] = cost;
    parent_[cell] = parent;
    queue_.emplace(cost, cell.y, cell.x);
  }

  Cell from_;
  int reach_;
  CellWindow<double> cost_;
  CellWindow<Cell> parent_;
  std::priority_queue<Open, std::vector<Open>, std::greater<>> queue_;
};

}  // namespace frontier_pilot::grids
