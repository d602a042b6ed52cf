#include "exploration/travel/coarse_space.h"

#include <algorithm>
#include <cmath>

#include "exploration/travel/neighbour_links.h"
#include "frontier_pilot/grids/cell_search.h"

namespace frontier_pilot::exploration {
namespace {

/// How many cells of `space` fit beside each other into one. Two places in neighbouring cells are at most 2 factor - 1
/// apart along an axis, and a wall between them keeps them apart by twice the clearance. [cells of `space`]
int factorFor(const TraversableSpace& space) {
  constexpr int kMost = 3;
  const double clearance = space.clearance() / space.geometry().resolution - 1e-6;
  return std::clamp(static_cast<int>(std::ceil(clearance + 0.5)) - 1, 1, kMost);
}

GridGeometry coarser(const GridGeometry& fine, int factor) {
  GridGeometry geometry = fine;
  geometry.resolution = fine.resolution * factor;
  geometry.width = (fine.width + factor - 1) / factor;
  geometry.height = (fine.height + factor - 1) / factor;
  return geometry;
}

/// The cells that stand for those of `fine`.
CellRect coarser(const CellRect& fine, int factor) {
  CellRect rect{fine.x / factor, fine.y / factor, 1, 1};
  rect.include(Cell{(fine.x + fine.width - 1) / factor, (fine.y + fine.height - 1) / factor});
  return rect;
}

}  // namespace

CellRect CoarseSpace::update(const TraversableSpace& space, const CellRect& changed) {
  factor_ = factorFor(space);
  const GridGeometry geometry = coarser(space.geometry(), factor_);
  CellRect area = changed.intersection(space.geometry().rect());
  if (geometry != passable_.geometry()) {
    passable_ = Grid<std::uint8_t>(geometry, 0);
    neighbours_ = Grid<std::uint8_t>(geometry, 0);
    area = space.geometry().rect();
  }
  if (area.empty()) return {};
  const CellRect window = coarser(area, factor_).intersection(geometry.rect());
  mark(space, window);
  const CellRect linked = window.grown(1).intersection(geometry.rect());
  linkNeighbours(passable_, linked, neighbours_);
  cutCorners(space, linked);
  return linked;
}

void CoarseSpace::mark(const TraversableSpace& space, const CellRect& window) {
  const GridGeometry& fine = space.geometry();
  for (int y = window.y; y < window.y + window.height; ++y) {
    for (int x = window.x; x < window.x + window.width; ++x) {
      const CellRect block = CellRect{x * factor_, y * factor_, factor_, factor_}.intersection(fine.rect());
      bool any = false;
      for (int row = block.y; row < block.y + block.height; ++row) {
        for (int column = block.x; column < block.x + block.width; ++column) {
          any = any || space.traversable({column, row});
        }
      }
      passable_[Cell{x, y}] = any ? 0xFF : 0;
    }
  }
}

/// Without such links the TravelField still finds every way: it leaves out a step only where another one leads there
/// that needs none of them.
void CoarseSpace::cutCorners(const TraversableSpace& space, const CellRect& window) {
  const auto at = [&](int cell, int step) { return cell * factor_ + (step > 0 ? factor_ - 1 : 0); };
  for (int y = window.y; y < window.y + window.height; ++y) {
    for (int x = window.x; x < window.x + window.width; ++x) {
      unsigned open = neighbours_[Cell{x, y}];
      for (unsigned d = 1; open != 0 && d < 8; d += 2) {
        const unsigned beside = 1U << (d - 1) | 1U << ((d + 1) & 7U);
        if ((open & 1U << d) == 0 || (open & beside) != 0) continue;
        const Cell corner{at(x, grids::kNeighbourSteps[d].x), at(y, grids::kNeighbourSteps[d].y)};
        if ((space.neighbours().get(corner, 0) & 1U << d) == 0) open &= ~(1U << d);
      }
      neighbours_[Cell{x, y}] = static_cast<std::uint8_t>(open);
    }
  }
}

}  // namespace frontier_pilot::exploration
