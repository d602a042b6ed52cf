#include <algorithm>
#include <optional>

#include "fleet/lattice.h"
#include "frontier_pilot/fleet/merged_map.h"
#include "frontier_pilot/grids/growing_grid.h"

namespace frontier_pilot::fleet {
namespace {

/// The side of the parts that a snapshot compares [cells]. Smaller ones are told apart better, but what is drawn anew
/// reaches some cells beyond each of them.
constexpr int kPart = 16;

void copy(const OccupancyGrid& from, const CellRect& cells, OccupancyGrid& to) {
  for (int y = cells.y; y < cells.y + cells.height; ++y)
    std::copy_n(from.row(y) + cells.x, cells.width, to.row(y) + cells.x);
}

}  // namespace

std::vector<CellRect> MapSnapshot::take(const OccupancyGrid& map, const CellRect& changed) {
  const GridGeometry& geometry = map.geometry();
  CellRect cells = changed.intersection(geometry.rect());
  if (geometry != map_.geometry()) {
    const std::optional<Cell> place = placeOfOld(map_.geometry(), geometry);
    if (!place) {
      map_ = map;
      return {geometry.rect()};
    }
    map_ = grids::resized(map_, geometry, *place, kUnknown);
    cells = geometry.rect();
  }
  std::vector<CellRect> differing;
  for (int y = cells.y; y < cells.y + cells.height; y += kPart) {
    for (int x = cells.x; x < cells.x + cells.width; x += kPart) {
      const CellRect part = difference(map_, map, CellRect{x, y, kPart, kPart}.intersection(cells));
      if (part.empty()) continue;
      copy(map, part, map_);
      differing.push_back(part);
    }
  }
  return differing;
}

}  // namespace frontier_pilot::fleet
