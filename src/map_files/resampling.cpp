#include "map_files/resampling.h"

#include <algorithm>
#include <cmath>

#include "frontier_pilot/core/bounds.h"

namespace frontier_pilot::map_files {
namespace {

constexpr double kSliver = 1e-6;  // [cells]: overlaps that are only due to rounding

/// What `cells` of `map`, which lie inside of it, amount to together.
std::int8_t mergedCell(const OccupancyGrid& map, const CellRect& cells) {
  std::int8_t merged = kUnknown;
  for (int y = cells.y; y < cells.y + cells.height; ++y) {
    for (int x = cells.x; x < cells.x + cells.width; ++x) {
      const std::int8_t value = map[Cell{x, y}];
      if (isOccupied(value)) return kOccupied;
      if (isFree(value)) merged = kFree;
    }
  }
  return merged;
}

}  // namespace

std::optional<OccupancyGrid> resampled(const OccupancyGrid& map, double resolution) {
  const double ratio = resolution / map.resolution();
  const double width = std::ceil(map.width() / ratio - kSliver);
  const double height = std::ceil(map.height() / ratio - kSliver);
  if (width * height > static_cast<double>(bounds::kMostMapCells)) return std::nullopt;
  GridGeometry geometry{resolution, map.geometry().origin, static_cast<int>(width), static_cast<int>(height)};
  OccupancyGrid result(geometry, kUnknown);
  const auto first = [ratio](int index) { return static_cast<int>(std::floor(index * ratio + kSliver)); };
  const auto end = [ratio](int index) { return static_cast<int>(std::ceil((index + 1) * ratio - kSliver)); };
  for (std::size_t i = 0; i < result.size(); ++i) {
    const Cell cell = geometry.cell(i);
    const CellRect under{first(cell.x), first(cell.y), end(cell.x) - first(cell.x), end(cell.y) - first(cell.y)};
    result[i] = mergedCell(map, under.intersection(map.geometry().rect()));
  }
  return result;
}

}  // namespace frontier_pilot::map_files
