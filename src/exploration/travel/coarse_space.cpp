#include "exploration/travel/coarse_space.h"

#include "exploration/travel/neighbour_links.h"

namespace frontier_pilot::exploration {
namespace {

GridGeometry coarser(const GridGeometry& fine) {
  GridGeometry geometry = fine;
  geometry.resolution = fine.resolution * CoarseSpace::kFactor;
  geometry.width = (fine.width + CoarseSpace::kFactor - 1) / CoarseSpace::kFactor;
  geometry.height = (fine.height + CoarseSpace::kFactor - 1) / CoarseSpace::kFactor;
  return geometry;
}

/// The cells that stand for those of `fine`.
CellRect coarser(const CellRect& fine) {
  CellRect rect{fine.x / CoarseSpace::kFactor, fine.y / CoarseSpace::kFactor, 1, 1};
  rect.include(
      Cell{(fine.x + fine.width - 1) / CoarseSpace::kFactor, (fine.y + fine.height - 1) / CoarseSpace::kFactor});
  return rect;
}

}  // namespace

void CoarseSpace::update(const TraversableSpace& space, const CellRect& changed) {
  const GridGeometry geometry = coarser(space.geometry());
  CellRect area = changed.intersection(space.geometry().rect());
  if (geometry != passable_.geometry()) {
    passable_ = Grid<std::uint8_t>(geometry, 0);
    neighbours_ = Grid<std::uint8_t>(geometry, 0);
    area = space.geometry().rect();
  }
  if (area.empty()) return;
  const CellRect window = coarser(area).intersection(geometry.rect());
  mark(space, window);
  linkNeighbours(passable_, window.grown(1).intersection(geometry.rect()), neighbours_);
}

void CoarseSpace::mark(const TraversableSpace& space, const CellRect& window) {
  const GridGeometry& fine = space.geometry();
  for (int y = window.y; y < window.y + window.height; ++y) {
    for (int x = window.x; x < window.x + window.width; ++x) {
      const CellRect block = CellRect{x * kFactor, y * kFactor, kFactor, kFactor}.intersection(fine.rect());
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

}  // namespace frontier_pilot::exploration
