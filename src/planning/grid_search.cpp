#include "planning/grid_search.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace frontier_pilot::planning {
namespace {

constexpr std::uint32_t kEveryDirection = 0xFF;

/// The directions in which the best path continues from a cell whose neighbours cost the same, for each set of
/// directions in which it may have come: straight on, and after a diagonal step also in its two components.
constexpr std::array<std::uint8_t, 256> continuedDirections() {
  std::array<std::uint8_t, 256> sets{};
  for (unsigned arrivals = 0; arrivals < sets.size(); ++arrivals) {
    unsigned continued = arrivals;
    for (unsigned i = 1; i < 8; i += 2) {
      if ((arrivals >> i & 1U) != 0) continued |= 1U << (i - 1) | 1U << (i + 1) % 8;
    }
    sets[arrivals] = static_cast<std::uint8_t>(continued);
  }
  return sets;
}
constexpr std::array<std::uint8_t, 256> kContinued = continuedDirections();

}  // namespace

void GridSearch::prepare(const ClearanceMap& map) {
  if (map.geometry() != geometry_ || nodes_.empty()) {
    geometry_ = map.geometry();
    nodes_.assign(geometry_.size(), Node{0, 0});
    number_ = 0;
  }
  if (++number_ >= (1U << (32 - kNumberShift))) {
    std::fill(nodes_.begin(), nodes_.end(), Node{0, 0});
    number_ = 1;
  }
  step_cost_ = stepCosts(map);
  offsets_ = grids::neighbourOffsets(geometry_.width);
}

void GridSearch::begin(Cell start, Cell goal) {
  start_ = start;
  goal_ = goal;
  expanded_ = 0;
  const auto index = static_cast<std::uint32_t>(geometry_.index(start));
  nodes_[index] = {0, number_ << kNumberShift | kEveryDirection << kArrivalShift | kPending};
  queue_.reset(octileCost(start, goal));
  queue_.push(index, octileCost(start, goal));
}

inline void GridSearch::relax(std::uint32_t index, std::uint32_t cost, std::uint32_t direction, Cell cell) {
  Node& node = nodes_[index];
  const std::uint32_t arrival = 1U << (kArrivalShift + direction);
  if (!written(node) || node.cost > cost) {
    node = {cost, number_ << kNumberShift | arrival | kPending | direction};
  } else if (node.cost == cost && (node.label & arrival) == 0) {
    const bool waits = (node.label & kPending) != 0;
    node.label |= arrival | kPending;
    if (waits) return;
  } else {
    return;
  }
  queue_.push(index, cost + octileCost(cell, goal_));
}

inline void GridSearch::expand(std::uint32_t index, std::uint32_t cost, std::uint32_t label) {
  const auto width = static_cast<std::uint32_t>(geometry_.width);
  const auto y = static_cast<int>(index / width);
  const Cell cell{static_cast<int>(index) - y * geometry_.width, y};
  const bool again = (label & kClosed) != 0;
  const bool inside = cell.x > 0 && cell.y > 0 && cell.x + 1 < geometry_.width && cell.y + 1 < geometry_.height;
  const std::uint8_t own = costs_[index] & ClearanceMap::kClassMask;
  std::array<std::uint8_t, 8> around{};
  bool uniform = true;
  for (std::size_t i = 0; i < 8; ++i) {
    const Cell step = grids::kNeighbourSteps[i];
    const bool there = inside || geometry_.contains({cell.x + step.x, cell.y + step.y});
    around[i] =
        there ? static_cast<std::uint8_t>(costs_[index + offsets_[i]] & ClearanceMap::kClassMask) : std::uint8_t{0};
    uniform = uniform && around[i] == own;
  }
  // A cell whose neighbours differ has been expanded in every direction.
  if (again && !uniform) return;
  if (uniform) {
    std::uint32_t left = kContinued[(label >> kArrivalShift) & kEveryDirection];
    for (std::uint32_t i = 0; left != 0; ++i, left >>= 1U) {
      if ((left & 1U) == 0) continue;
      const Cell step = grids::kNeighbourSteps[i];
      relax(static_cast<std::uint32_t>(index + offsets_[i]), cost + step_cost_[own][i % 2], i,
            {cell.x + step.x, cell.y + step.y});
    }
    return;
  }
  for (std::uint32_t i = 0; i < 8; ++i) {
    const bool diagonal = i % 2 == 1;
    if (around[i] == 0 || (diagonal && (around[i - 1] == 0 || around[(i + 1) % 8] == 0))) continue;
    const Cell step = grids::kNeighbourSteps[i];
    relax(static_cast<std::uint32_t>(index + offsets_[i]), cost + step_cost_[around[i]][i % 2], i,
          {cell.x + step.x, cell.y + step.y});
  }
}

bool GridSearch::search(const ClearanceMap& map, const Grid<std::uint8_t>& classes, Cell start, Cell goal) {
  prepare(map);
  costs_ = classes.cells().data();
  begin(start, goal);
  const auto goal_index = static_cast<std::uint32_t>(geometry_.index(goal));
  while (!queue_.empty()) {
    const std::uint32_t index = queue_.pop();
    Node& node = nodes_[index];
    const std::uint32_t label = node.label;
    if ((label & kPending) == 0) continue;
    if ((label & kClosed) == 0) ++expanded_;
    node.label = (label & ~kPending) | kClosed;
    if (index == goal_index) return true;
    expand(index, node.cost, label);
  }
  return false;
}

bool GridSearch::reached(Cell cell) const {
  if (!geometry_.contains(cell)) return false;
  const Node& node = nodes_[geometry_.index(cell)];
  return written(node) && (node.label & kClosed) != 0;
}

std::vector<Cell> GridSearch::pathTo(Cell cell) const {
  std::vector<Cell> path{cell};
  while (path.back() != start_) {
    const Cell at = path.back();
    const Cell step = grids::kNeighbourSteps[nodes_[geometry_.index(at)].label & kDirectionMask];
    path.push_back({at.x - step.x, at.y - step.y});
  }
  std::reverse(path.begin(), path.end());
  return path;
}

}  // namespace frontier_pilot::planning
