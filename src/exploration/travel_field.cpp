#include "frontier_pilot/exploration/travel_field.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "frontier_pilot/core/cell_window.h"

namespace frontier_pilot {
namespace {

constexpr std::array<int, 8> kStepX = {1, 1, 0, -1, -1, -1, 0, 1};
constexpr std::array<int, 8> kStepY = {0, 1, 1, 1, 0, -1, -1, -1};
constexpr unsigned kNoDirection = 8;  ///< of a seed: it expands to all sides

/// The directions in which a cell, entered in a direction, has to go on, by the mask of its traversable neighbours:
/// the natural ones, and those forced because the obstacle beside them blocks the other way around.
class SuccessorTable {
 public:
  SuccessorTable() {
    for (unsigned open = 0; open < 256; ++open) {
      for (unsigned d = 0; d < 8; ++d) at(d, open) = static_cast<std::uint8_t>(successors(d, open) & open);
      at(kNoDirection, open) = static_cast<std::uint8_t>(open);
    }
  }
  unsigned operator()(unsigned direction, unsigned open) const { return table_[direction * 256 + open]; }

 private:
  static unsigned bit(unsigned direction) { return 1U << (direction & 7U); }
  static unsigned successors(unsigned d, unsigned open) {
    const bool diagonal = (d & 1U) != 0;
    const unsigned side = diagonal ? 3 : 2;  // where an obstacle forces, seen from the direction of travel
    unsigned result = bit(d);
    if (diagonal) result |= bit(d + 1) | bit(d + 7);
    if ((open & bit(d + side)) == 0) result |= bit(d + side - 1);
    if ((open & bit(d + 8 - side)) == 0) result |= bit(d + 9 - side);
    return result;
  }
  std::uint8_t& at(unsigned direction, unsigned open) { return table_[direction * 256 + open]; }

  std::array<std::uint8_t, std::size_t{9} * 256> table_{};
};

std::array<std::ptrdiff_t, 8> stepOffsets(int width) {
  std::array<std::ptrdiff_t, 8> offsets{};
  for (std::size_t d = 0; d < 8; ++d) offsets[d] = kStepX[d] + static_cast<std::ptrdiff_t>(kStepY[d]) * width;
  return offsets;
}

}  // namespace

void TravelField::compute(const TraversableSpace& space, const OccupancyGrid& map, Cell start, double escape_radius) {
  if (units_.geometry() != map.geometry()) {
    units_ = Grid<std::uint32_t>(map.geometry(), kUnreached);
  } else {
    std::fill(units_.cells().begin(), units_.cells().end(), kUnreached);
  }
  reached_count_ = 0;
  if (!map.contains(start)) return;
  seed(space, map, start, escape_radius);
  for (std::uint32_t units = 0; pending_ > 0; ++units) expandBucket(buckets_[units % kBuckets], space, units);
}

bool TravelField::anyReached(const CellRect& rect) const {
  const CellRect box = rect.intersection(geometry().rect());
  std::uint32_t all = kUnreached;
  for (int y = box.y; y < box.y + box.height; ++y) {
    const std::uint32_t* row = units_.row(y) + box.x;
    for (int x = 0; x < box.width; ++x) all &= row[x];  // the unreached have all bits set
  }
  return all != kUnreached;
}

double TravelField::distance(Cell c) const {
  const std::uint32_t units = units_.get(c, kUnreached);
  if (units == kUnreached) return std::numeric_limits<double>::infinity();
  return units * geometry().resolution / kStraight;
}

void TravelField::push(std::size_t index, unsigned direction, std::uint32_t units) {
  units_[index] = units;
  buckets_[units % kBuckets].push_back(static_cast<std::uint32_t>(index << 4U | direction));
  ++pending_;
}

/// Breadth-first over cells that are not occupied, from the robot's own to the traversable ones around.
void TravelField::seed(const TraversableSpace& space, const OccupancyGrid& map, Cell start, double escape_radius) {
  if (space.traversable(start)) return push(map.geometry().index(start), kNoDirection, 0);
  const int reach = std::min(static_cast<int>(escape_radius / map.resolution()),
                             static_cast<int>((kBuckets - kDiagonal - 1) / kDiagonal));
  CellWindow<std::uint32_t> steps(start, reach, kUnreached);
  const CellRect box = CellRect{start.x, start.y, 1, 1}.grown(reach).intersection(map.geometry().rect());
  std::vector<Cell> queue = {start};
  steps[start] = 0;
  for (std::size_t i = 0; i < queue.size(); ++i) {
    const Cell cell = queue[i];
    if (space.traversable(cell)) {
      push(map.geometry().index(cell), kNoDirection, steps[cell] * kDiagonal);
      continue;
    }
    for (std::size_t d = 0; d < 8; ++d) {
      const Cell next{cell.x + kStepX[d], cell.y + kStepY[d]};
      if (!box.contains(next) || steps[next] != kUnreached || isOccupied(map[next])) continue;
      steps[next] = steps[cell] + 1;
      queue.push_back(next);
    }
  }
}

void TravelField::expandBucket(std::vector<std::uint32_t>& bucket, const TraversableSpace& space, std::uint32_t units) {
  static const SuccessorTable table;
  const std::array<std::ptrdiff_t, 8> offsets = stepOffsets(space.geometry().width);
  const std::uint8_t* open = space.neighbours().cells().data();
  for (const std::uint32_t entry : bucket) {  // no step ends in its own bucket
    const std::size_t index = entry >> 4U;
    if (units_[index] != units) continue;  // reached on a shorter way since
    ++reached_count_;
    unsigned successors = table(entry & 15U, open[index]);
    for (unsigned d = 0; successors != 0; ++d, successors >>= 1U) {
      if ((successors & 1U) == 0) continue;
      const auto next = static_cast<std::size_t>(static_cast<std::ptrdiff_t>(index) + offsets[d]);
      const std::uint32_t reach = units + ((d & 1U) != 0 ? kDiagonal : kStraight);
      if (reach < units_[next]) push(next, d, reach);
    }
  }
  pending_ -= bucket.size();
  bucket.clear();
}

}  // namespace frontier_pilot
