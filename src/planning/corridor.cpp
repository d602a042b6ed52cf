#include "planning/corridor.h"

#include <algorithm>
#include <limits>

namespace frontier_pilot::planning {
namespace {

constexpr std::uint32_t kUnreached = std::numeric_limits<std::uint32_t>::max();
/// How much more than the cheapest a path over the blocks may cost: two blocks, which is what the way over blocks and
/// that over cells differ by at corners and at the ends.
constexpr std::uint32_t kMargin = 2 * kStraightCost;

CellRect cellsOf(Cell block, const GridGeometry& cells) {
  return CellRect{block.x * kBlockSide, block.y * kBlockSide, kBlockSide, kBlockSide}.intersection(cells.rect());
}

Cell blockOf(Cell cell) { return {cell.x / kBlockSide, cell.y / kBlockSide}; }

Cell neighbour(Cell block, std::size_t direction) {
  const Cell step = grids::kNeighbourSteps[direction];
  return {block.x + step.x, block.y + step.y};
}

}  // namespace

void Corridor::prepare(const ClearanceMap& map) {
  if (map.geometry() != classes_.geometry() || blocks_.empty()) {
    classes_ = Grid<std::uint8_t>(map.geometry(), 0);
    inside_.clear();
    grid_ = GridGeometry();
    grid_.width = (map.geometry().width + kBlockSide - 1) / kBlockSide;
    grid_.height = (map.geometry().height + kBlockSide - 1) / kBlockSide;
    offsets_ = grids::neighbourOffsets(grid_.width);
    blocks_.assign(grid_.size(), Block{0, 0, 0, 0});
    number_ = 0;
  }
  if (++number_ >= (1U << (32 - kNumberShift))) {
    std::fill(blocks_.begin(), blocks_.end(), Block{0, 0, 0, 0});
    number_ = 1;
  }
  step_cost_ = stepCosts(map);
}

void Corridor::close() {
  for (const Cell block : inside_) {
    const CellRect cells = cellsOf(block, classes_.geometry());
    for (int y = cells.y; y < cells.y + cells.height; ++y) {
      std::fill_n(classes_.row(y) + cells.x, cells.width, std::uint8_t{0});
    }
  }
  inside_.clear();
}

void Corridor::open(const ClearanceMap& map, Cell block) {
  const CellRect cells = cellsOf(block, classes_.geometry());
  for (int y = cells.y; y < cells.y + cells.height; ++y) {
    const std::uint8_t* from = map.costs().row(y) + cells.x;
    std::uint8_t* to = classes_.row(y) + cells.x;
    for (int i = 0; i < cells.width; ++i) to[i] = from[i] & ClearanceMap::kClassMask;
  }
  inside_.push_back(block);
}

inline Corridor::Block& Corridor::visit(const ClearanceMap& map, Cell block) {
  Block& entry = blocks_[grid_.index(block)];
  if (entry.label >> kNumberShift != number_) {
    const BlockSummary summary = summarise(map, block);
    entry = {kUnreached, kUnreached, number_ << kNumberShift | summary.cost_class, summary.cells};
  }
  return entry;
}

/// The neighbours that one can step to from `block`; all of its neighbours are visited.
inline unsigned Corridor::links(const ClearanceMap& map, Cell block) {
  Around around{};
  for (std::size_t i = 0; i < around.size(); ++i) {
    const Cell next = neighbour(block, i);
    if (grid_.contains(next)) around[i] = visit(map, next).cells;
  }
  return linkedNeighbours(blocks_[grid_.index(block)].cells, around);
}

/// Settles `to_goal` of all blocks through which a path within the bound may lead. Returns whether `start` is one.
bool Corridor::searchBack(const ClearanceMap& map, Cell start, Cell goal, std::uint32_t least_bound) {
  bound_ = kUnreached;
  visit(map, goal).to_goal = 0;
  queue_.reset(octileCost(goal, start));
  queue_.push(static_cast<std::uint32_t>(grid_.index(goal)), octileCost(goal, start));
  while (!queue_.empty()) {
    const std::uint32_t index = queue_.pop();
    Block& entry = blocks_[index];
    if ((entry.label & kSettled) != 0) continue;
    const Cell block = grid_.cell(index);
    if (entry.to_goal + octileCost(block, start) > bound_) break;
    entry.label |= kSettled;
    if (block == start) bound_ = std::max(entry.to_goal + kMargin, least_bound);
    const auto& step = step_cost_[entry.label & kClassMask];
    unsigned left = links(map, block);
    for (std::size_t i = 0; left != 0; ++i, left >>= 1U) {
      if ((left & 1U) == 0) continue;
      const auto next = static_cast<std::uint32_t>(index + offsets_[i]);
      const std::uint32_t cost = entry.to_goal + step[i % 2];
      if (cost >= blocks_[next].to_goal) continue;
      blocks_[next].to_goal = cost;
      queue_.push(next, cost + octileCost(neighbour(block, i), start));
    }
  }
  return bound_ != kUnreached;
}

/// Opens the blocks on paths within the bound.
void Corridor::searchForward(const ClearanceMap& map, Cell start) {
  const auto first = static_cast<std::uint32_t>(grid_.index(start));
  blocks_[first].from_start = 0;
  queue_.reset(blocks_[first].to_goal);
  queue_.push(first, blocks_[first].to_goal);
  while (!queue_.empty()) {
    const std::uint32_t index = queue_.pop();
    Block& entry = blocks_[index];
    if ((entry.label & kInside) != 0) continue;
    entry.label |= kInside;
    const Cell block = grid_.cell(index);
    open(map, block);
    unsigned left = links(map, block);
    for (std::size_t i = 0; left != 0; ++i, left >>= 1U) {
      if ((left & 1U) == 0) continue;
      const auto next = static_cast<std::uint32_t>(index + offsets_[i]);
      Block& other = blocks_[next];
      if ((other.label & kSettled) == 0) continue;
      const std::uint32_t cost = entry.from_start + step_cost_[other.label & kClassMask][i % 2];
      if (cost >= other.from_start || cost + other.to_goal > bound_) continue;
      other.from_start = cost;
      queue_.push(next, cost + other.to_goal);
    }
  }
}

bool Corridor::find(const ClearanceMap& map, Cell start, Cell goal, std::uint32_t least_bound) {
  prepare(map);
  close();
  if (!searchBack(map, blockOf(start), blockOf(goal), least_bound / kBlockSide)) return false;
  searchForward(map, blockOf(start));
  return true;
}

}  // namespace frontier_pilot::planning
