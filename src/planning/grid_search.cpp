#include "planning/grid_search.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace frontier_pilot::planning {
namespace {

// 99/70 is the square root of two to a relative error of 5e-5.
constexpr std::uint32_t kStraight = 70;
constexpr std::uint32_t kDiagonal = 99;

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
  for (int i = 1; i < ClearanceMap::kClasses; ++i) {
    step_cost_[static_cast<std::size_t>(i)] = {static_cast<std::uint32_t>(std::lround(kStraight * map.weight(i))),
                                               static_cast<std::uint32_t>(std::lround(kDiagonal * map.weight(i)))};
  }
  offsets_ = grids::neighbourOffsets(geometry_.width);
}

std::uint32_t GridSearch::heuristic(Cell cell) const {
  const auto dx = static_cast<std::uint32_t>(std::abs(cell.x - goal_.x));
  const auto dy = static_cast<std::uint32_t>(std::abs(cell.y - goal_.y));
  return kStraight * std::max(dx, dy) + (kDiagonal - kStraight) * std::min(dx, dy);
}

void GridSearch::begin(Cell start, Cell goal) {
  start_ = start;
  goal_ = goal;
  expanded_ = 0;
  const auto index = static_cast<std::uint32_t>(geometry_.index(start));
  nodes_[index] = {0, number_ << kNumberShift};
  queue_.reset(heuristic(start));
  queue_.push(index, heuristic(start));
}

bool GridSearch::search(const ClearanceMap& map, Cell start, Cell goal) {
  prepare(map);
  begin(start, goal);
  const auto goal_index = static_cast<std::uint32_t>(geometry_.index(goal));
  while (!queue_.empty()) {
    const std::uint32_t index = queue_.pop();
    if ((nodes_[index].label & kClosed) != 0) continue;
    nodes_[index].label |= kClosed;
    ++expanded_;
    if (index == goal_index) return true;
    expand(map, index);
  }
  return false;
}

void GridSearch::expand(const ClearanceMap& map, std::uint32_t index) {
  const Cell cell = geometry_.cell(index);
  const std::uint8_t* costs = map.costs().cells().data();
  const std::uint32_t cost = nodes_[index].cost;
  const bool inside = cell.x > 0 && cell.y > 0 && cell.x + 1 < geometry_.width && cell.y + 1 < geometry_.height;
  std::array<std::uint8_t, 8> around{};
  for (std::size_t i = 0; i < 8; ++i) {
    const Cell step = grids::kNeighbourSteps[i];
    const bool there = inside || geometry_.contains({cell.x + step.x, cell.y + step.y});
    around[i] =
        there ? static_cast<std::uint8_t>(costs[index + offsets_[i]] & ClearanceMap::kClassMask) : std::uint8_t{0};
  }
  for (std::size_t i = 0; i < 8; ++i) {
    const bool diagonal = i % 2 == 1;
    if (around[i] == 0 || (diagonal && (around[i - 1] == 0 || around[(i + 1) % 8] == 0))) continue;
    const auto next = static_cast<std::uint32_t>(index + offsets_[i]);
    relax(next, cost + step_cost_[around[i]][diagonal ? 1 : 0], static_cast<std::uint32_t>(i));
  }
}

void GridSearch::relax(std::uint32_t index, std::uint32_t cost, std::uint32_t direction) {
  Node& node = nodes_[index];
  if (written(index) && ((node.label & kClosed) != 0 || node.cost <= cost)) return;
  node = {cost, number_ << kNumberShift | direction};
  queue_.push(index, cost + heuristic(geometry_.cell(index)));
}

bool GridSearch::reached(Cell cell) const {
  if (!geometry_.contains(cell)) return false;
  const auto index = static_cast<std::uint32_t>(geometry_.index(cell));
  return written(index) && (nodes_[index].label & kClosed) != 0;
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
