#include "frontier_pilot/core/grid.h"

#include <algorithm>
#include <iterator>

namespace frontier_pilot {

void CellRect::include(Cell c) { include(CellRect{c.x, c.y, 1, 1}); }

void CellRect::include(const CellRect& other) {
  if (other.empty()) return;
  if (empty()) {
    *this = other;
    return;
  }
  const int right = std::max(x + width, other.x + other.width);
  const int top = std::max(y + height, other.y + other.height);
  x = std::min(x, other.x);
  y = std::min(y, other.y);
  width = right - x;
  height = top - y;
}

CellRect CellRect::intersection(const CellRect& other) const {
  const int left = std::max(x, other.x);
  const int bottom = std::max(y, other.y);
  const int right = std::min(x + width, other.x + other.width);
  const int top = std::min(y + height, other.y + other.height);
  return {left, bottom, std::max(0, right - left), std::max(0, top - bottom)};
}

bool operator==(const CellRect& a, const CellRect& b) {
  return a.x == b.x && a.y == b.y && a.width == b.width && a.height == b.height;
}

bool operator==(const GridGeometry& a, const GridGeometry& b) {
  return a.resolution == b.resolution && a.origin == b.origin && a.width == b.width && a.height == b.height;
}

CellRect difference(const OccupancyGrid& a, const OccupancyGrid& b) {
  CellRect changed;
  for (int y = 0; y < a.height(); ++y) {
    const std::int8_t* end = a.row(y) + a.width();
    const auto first = std::mismatch(a.row(y), end, b.row(y)).first;
    if (first == end) continue;
    const auto back = std::mismatch(std::make_reverse_iterator(end), std::make_reverse_iterator(first),
                                    std::make_reverse_iterator(b.row(y) + b.width()));
    const int x = static_cast<int>(first - a.row(y));
    const int past = static_cast<int>(back.first.base() - a.row(y));
    changed.include(CellRect{x, y, past - x, 1});
  }
  return changed;
}

}  // namespace frontier_pilot
