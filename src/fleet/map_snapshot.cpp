#include <algorithm>
#include <cstring>
#include <optional>

#include "fleet/lattice.h"
#include "frontier_pilot/fleet/merged_map.h"
#include "frontier_pilot/grids/growing_grid.h"

namespace frontier_pilot::fleet {
namespace {

/// The side of the parts that a snapshot compares [cells]. Smaller ones are told apart better, but what is drawn anew
/// reaches some cells beyond each of them.
constexpr int kPart = 16;

/// Copies the cells `part` of `map`, and returns the box around those that were different.
CellRect update(OccupancyGrid& copy, const OccupancyGrid& map, const CellRect& part) {
  CellRect differing;
  for (int y = part.y; y < part.y + part.height; ++y) {
    const std::int8_t* from = map.row(y) + part.x;
    std::int8_t* to = copy.row(y) + part.x;
    const auto width = static_cast<std::size_t>(part.width);
    if (std::memcmp(from, to, width) == 0) continue;
    const auto first = std::mismatch(from, from + part.width, to).first - from;
    std::memcpy(to, from, width);
    differing.include(CellRect{part.x + static_cast<int>(first), y, part.width - static_cast<int>(first), 1});
  }
  return differing;
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
      const CellRect part = update(map_, map, CellRect{x, y, kPart, kPart}.intersection(cells));
      if (!part.empty()) differing.push_back(part);
    }
  }
  return differing;
}

}  // namespace frontier_pilot::fleet
