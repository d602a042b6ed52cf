#include "exploration/travel/travel_field.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "frontier_pilot/grids/cell_search.h"

namespace frontier_pilot::exploration {
namespace {

constexpr unsigned kNoDirection = 8;  ///< of a seed, which is expanded in all directions

/// The directions in which a cell has to be expanded, by the direction it was entered in and the mask of its
/// traversable neighbours: the natural successors, and those forced because an obstacle blocks the alternative path.
class SuccessorTable {
 public:
  constexpr SuccessorTable() {
    for (unsigned open = 0; open < 256; ++open) {
      for (unsigned d = 0; d < 8; ++d) at(d, open) = static_cast<std::uint8_t>(successors(d, open) & open);
      at(kNoDirection, open) = static_cast<std::uint8_t>(open);
    }
  }
  constexpr unsigned operator()(unsigned direction, unsigned open) const { return table_[direction * 256 + open]; }

 private:
  static constexpr unsigned bit(unsigned direction) { return 1U << (direction & 7U); }
  static constexpr unsigned successors(unsigned d, unsigned open) {
    const bool diagonal = (d & 1U) != 0;
    const unsigned side = diagonal ? 3 : 2;  // of an obstacle that forces a successor, relative to d [45 degrees]
    unsigned result = bit(d);
    if (diagonal) result |= bit(d + 1) | bit(d + 7);
    if ((open & bit(d + side)) == 0) result |= bit(d + side - 1);
    if ((open & bit(d + 8 - side)) == 0) result |= bit(d + 9 - side);
    return result;
  }
  constexpr std::uint8_t& at(unsigned direction, unsigned open) { return table_[direction * 256 + open]; }

  std::array<std::uint8_t, std::size_t{9} * 256> table_{};
};

constexpr SuccessorTable kSuccessors;

/// The steps of a search for the end of a way: each costs one, and none leads onto an obstacle or off the map.
auto overFreeCells(const OccupancyGrid& map) {
  return [&map](Cell, Cell next) { return map.contains(next) && !isOccupied(map[next]) ? 1.0 : -1.0; };
}

}  // namespace

void TravelField::compute(const TraversableSpace& space, const OccupancyGrid& map, Cell start, double escape_radius) {
  restart(map.geometry(), map.geometry().rect());
  if (!map.contains(start)) return;
  seed(space, map, start, escape_radius);
  spread(space.neighbours(), kUnreached, [](std::uint32_t) { return false; });
}

void TravelField::compute(const Grid<std::uint8_t>& neighbours, Cell start, double farthest) {
  spread(neighbours, begin(neighbours, start, farthest), [](std::uint32_t) { return false; });
}

void TravelField::compute(const Grid<std::uint8_t>& neighbours, Cell start, double farthest,
                          const std::vector<Cell>& targets) {
  auto next = targets.begin();
  spread(neighbours, begin(neighbours, start, farthest), [&](std::uint32_t units) {
    while (next != targets.end() && units_.get(*next, kUnreached) <= units) ++next;
    return next == targets.end();
  });
}

/// Queues `start`; returns `farthest` in the units of the labels.
std::uint32_t TravelField::begin(const Grid<std::uint8_t>& neighbours, Cell start, double farthest) {
  const GridGeometry& geometry = neighbours.geometry();
  constexpr double kMostCells = 5e8;  // more than a path on any map has
  const double cells = std::min(std::ceil(farthest / geometry.resolution), kMostCells);
  const int reach = static_cast<int>(cells) + static_cast<int>(kRun) + 1;
  restart(geometry, CellRect{start.x, start.y, 1, 1}.grown(reach).intersection(geometry.rect()));
  if (neighbours.get(start, 0) != 0) push(geometry.index(start), kNoDirection, 0);
  return static_cast<std::uint32_t>(kStraight * cells);
}

/// `window` will hold all cells that are reached.
void TravelField::restart(const GridGeometry& geometry, const CellRect& window) {
  if (units_.geometry() != geometry) {
    units_ = Grid<std::uint32_t>(geometry, kUnreached);
  } else {
    for (int y = labelled_.y; y < labelled_.y + labelled_.height; ++y) {
      std::fill_n(units_.row(y) + labelled_.x, labelled_.width, kUnreached);
    }
  }
  labelled_ = window;
  reached_count_ = 0;
  offsets_ = grids::neighbourOffsets(geometry.width);
  queue_.reset(0);
}

template <class Ended>
void TravelField::spread(const Grid<std::uint8_t>& neighbours, std::uint32_t farthest, Ended ended) {
  const std::uint8_t* open = neighbours.cells().data();
  std::uint32_t done = 0;
  while (!queue_.empty() && !ended(done)) {
    queue_.popLeast([&](std::uint32_t entry, std::uint32_t units) {
      done = units;
      const std::size_t index = entry >> 4U;
      // A label that differs belongs to a shorter path that was found since.
      if (units <= farthest && units_[index] == units) expandCell(index, entry & 15U, units, open);
    });
  }
}

std::optional<Cell> TravelField::nearestReached(const OccupancyGrid& map, Cell place, double radius) const {
  std::optional<Cell> nearest;
  const auto is_end = [&](Cell cell) { return nearest || reached(cell); };
  grids::ExitSearch(place, static_cast<int>(radius / map.resolution()))
      .run(false, is_end, overFreeCells(map), [&](Cell cell, double) { nearest = nearest.value_or(cell); });
  return nearest;
}

bool TravelField::anyReached(const CellRect& rect) const {
  const CellRect box = rect.intersection(geometry().rect());
  for (int y = box.y; y < box.y + box.height; ++y) {
    const std::uint32_t* row = units_.row(y) + box.x;
    std::uint32_t all = kUnreached;
    for (int x = 0; x < box.width; ++x) all &= row[x];  // unreached cells have all bits set
    if (all != kUnreached) return true;
  }
  return false;
}

std::size_t TravelField::countReached(const CellRect& rect) const {
  const CellRect box = rect.intersection(geometry().rect());
  std::uint32_t count = 0;
  for (int y = box.y; y < box.y + box.height; ++y) {
    const std::uint32_t* row = units_.row(y) + box.x;
    for (int x = 0; x < box.width; ++x) count += row[x] != kUnreached ? 1U : 0U;
  }
  return count;
}

double TravelField::distance(Cell c) const {
  const std::uint32_t units = units_.get(c, kUnreached);
  if (units == kUnreached) return std::numeric_limits<double>::infinity();
  return units * geometry().resolution / kStraight;
}

void TravelField::label(std::size_t index, std::uint32_t units) {
  if (units_[index] == kUnreached) ++reached_count_;
  units_[index] = units;
}

void TravelField::push(std::size_t index, unsigned direction, std::uint32_t units) {
  label(index, units);
  queue_.push(static_cast<std::uint32_t>(index << 4U | direction), units);
}

/// Each traversable cell that is the first on a path from the robot is a seed, at a distance as if every step to it
/// were diagonal.
void TravelField::seed(const TraversableSpace& space, const OccupancyGrid& map, Cell start, double escape_radius) {
  if (space.traversable(start)) return push(map.geometry().index(start), kNoDirection, 0);
  const int reach = std::min(static_cast<int>(escape_radius / map.resolution()),
                             static_cast<int>((kBuckets - kDiagonal - 1) / kDiagonal));
  grids::ExitSearch(start, reach)
      .run(
          false, [&](Cell cell) { return space.traversable(cell); }, overFreeCells(map),
          [&](Cell cell, double steps) {
            push(map.geometry().index(cell), kNoDirection, static_cast<std::uint32_t>(steps) * kDiagonal);
          });
}

void TravelField::expandCell(std::size_t index, unsigned direction, std::uint32_t units, const std::uint8_t* open) {
  for (unsigned left = kSuccessors(direction, open[index]); left != 0; left &= left - 1) {
    const auto d = static_cast<unsigned>(__builtin_ctz(left));
    if ((d & 1U) == 0) {
      goStraight(index, d, units, open);
    } else if (const std::size_t next = index + offsets_[d]; units + kDiagonal < units_[next]) {
      push(next, d, units + kDiagonal);
    }
  }
}

/// Labels up to kRun cells straight ahead. Ends at a cell that has been reached on a path no longer than this, or
/// queues the last cell: one that must be expanded in other directions than straight ahead, or the end of the run. A
/// shorter path may later replace a label that was set ahead of the queue's order.
void TravelField::goStraight(std::size_t index, unsigned direction, std::uint32_t units, const std::uint8_t* open) {
  const std::size_t step = offsets_[direction];
  for (const std::uint32_t end = units + kRun * kStraight; units < end;) {
    index += step;
    units += kStraight;
    if (units >= units_[index]) return;
    label(index, units);
    if (kSuccessors(direction, open[index]) != (1U << direction)) break;
  }
  push(index, direction, units);
}

Cell nextTowardsOrigin(const TravelField& field, Cell cell) {
  Cell next = cell;
  for (const Cell step : grids::kNeighbourSteps) {
    const Cell neighbour{cell.x + step.x, cell.y + step.y};
    if (field.distance(neighbour) < field.distance(next)) next = neighbour;
  }
  return next;
}

}  // namespace frontier_pilot::exploration
