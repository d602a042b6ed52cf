#include <algorithm>
#include <cmath>

#include "exploration/travel/neighbour_links.h"
#include "exploration/travel/travel_field.h"

namespace frontier_pilot::exploration {
namespace {

using Row = std::vector<std::uint8_t>;

/// Half-widths [cells] of the disc of cells nearer than `radius` cells to its centre.
std::vector<int> discHalfWidths(double radius) {
  std::vector<int> widths;
  for (int dy = 0; dy < radius; ++dy) {
    int w = 0;
    while ((w + 1) * (w + 1) + dy * dy < radius * radius) ++w;
    widths.push_back(w);
  }
  return widths;
}

/// Each cell becomes the union with its two neighbours in the row. Both rows have a margin of one cell at each end.
void widen(Row& row, Row& scratch) {
  scratch = row;
  for (std::size_t x = 1; x + 1 < row.size(); ++x) {
    row[x] = static_cast<std::uint8_t>(scratch[x - 1] | scratch[x] | scratch[x + 1]);
  }
}

/// Writes 0xFF where cells [0, n) of `from` are obstacles, after one cell of margin; returns whether there are any.
bool readObstacles(const std::int8_t* from, int n, KeepClearOf obstacles, Row& row) {
  row.assign(static_cast<std::size_t>(n) + 2, 0);
  // Unknown cells are negative: as unsigned bytes they are greater than 127.
  const std::uint8_t top = obstacles == KeepClearOf::kObstacles ? 127 : 255;
  std::uint8_t any = 0;
  std::uint8_t* out = row.data() + 1;
  for (int i = 0; i < n; ++i) {
    const auto value = static_cast<std::uint8_t>(from[i]);
    out[i] = static_cast<std::uint8_t>(-(static_cast<int>(value >= 50) & static_cast<int>(value <= top)));
    any = static_cast<std::uint8_t>(any | out[i]);
  }
  return any != 0;
}

}  // namespace

CellRect TraversableSpace::update(const OccupancyGrid& map, const CellRect& changed) {
  CellRect area = changed;
  if (passable_.geometry() != map.geometry() || passable_.empty()) {
    passable_ = Grid<std::uint8_t>(map.geometry());
    neighbours_ = Grid<std::uint8_t>(map.geometry());
    // Slightly less than the clearance, so that a cell exactly that far away is traversable.
    half_widths_ = discHalfWidths(clearance_ / map.resolution() - 1e-6);
    area = map.geometry().rect();
  }
  const CellRect window = area.grown(static_cast<int>(half_widths_.size())).intersection(map.geometry().rect());
  if (window.empty()) return window;
  markNearObstacles(map, window);
  keepFree(map, window);
  linkNeighbours(passable_, window.grown(1).intersection(map.geometry().rect()), neighbours_);
  return window;
}

/// Writes 0xFF to the cells of `window` that are too near to a cell to keep clear of, 0 to the others.
void TraversableSpace::markNearObstacles(const OccupancyGrid& map, const CellRect& window) {
  const int margin = static_cast<int>(half_widths_.size());
  const CellRect source = window.grown(margin).intersection(map.geometry().rect());
  const auto width = static_cast<std::size_t>(window.width);
  for (int y = window.y; y < window.y + window.height; ++y) std::fill_n(passable_.row(y) + window.x, width, 0);
  Row row, scratch;
  for (int y = source.y; y < source.y + source.height; ++y) {
    if (!readObstacles(map.row(y) + source.x, source.width, obstacles_, row)) continue;
    int width_now = 0;
    for (int dy = margin - 1; dy >= 0; --dy) {  // from the disc's outermost row, the narrowest, inwards
      const int wanted = half_widths_[static_cast<std::size_t>(dy)];
      for (; width_now < wanted; ++width_now) widen(row, scratch);
      const std::uint8_t* near = row.data() + 1 + (window.x - source.x);
      for (const int target : {y - dy, y + dy}) {
        if (target < window.y || target >= window.y + window.height) continue;
        std::uint8_t* out = passable_.row(target) + window.x;
        for (std::size_t x = 0; x < width; ++x) out[x] = static_cast<std::uint8_t>(out[x] | near[x]);
      }
    }
  }
}

/// Turns "too near" into "passable": free and not too near.
void TraversableSpace::keepFree(const OccupancyGrid& map, const CellRect& window) {
  for (int y = window.y; y < window.y + window.height; ++y) {
    const std::int8_t* cells = map.row(y) + window.x;
    std::uint8_t* out = passable_.row(y) + window.x;
    for (int x = 0; x < window.width; ++x) {
      const int good =
          static_cast<int>(cells[x] >= 0) & static_cast<int>(cells[x] < 50) & static_cast<int>(out[x] == 0);
      out[x] = static_cast<std::uint8_t>(-good);
    }
  }
}

}  // namespace frontier_pilot::exploration
