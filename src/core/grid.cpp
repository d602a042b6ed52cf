#include "frontier_pilot/core/grid.h"

#include <algorithm>
#include <iterator>
#include <limits>

namespace frontier_pilot {
namespace {

/// Consecutive cells along one axis, [low, high), as 64-bit integers so that nothing overflows.
struct Extent {
  std::int64_t low, high;
  int first() const { return cut(low); }
  int size() const { return cut(high - first()); }

 private:
  static int cut(std::int64_t value) {
    using Ints = std::numeric_limits<int>;
    return static_cast<int>(std::clamp<std::int64_t>(value, Ints::min(), Ints::max()));
  }
};

Extent extent(int first, int size) { return {first, std::int64_t{first} + size}; }
Extent join(const Extent& a, const Extent& b) { return {std::min(a.low, b.low), std::max(a.high, b.high)}; }
Extent meet(const Extent& a, const Extent& b) {
  const std::int64_t low = std::max(a.low, b.low);
  return {low, std::max(low, std::min(a.high, b.high))};
}
Extent widen(const Extent& a, int margin) { return {a.low - margin, a.high + margin}; }

CellRect block(const Extent& x, const Extent& y) { return {x.first(), y.first(), x.size(), y.size()}; }

}  // namespace

void CellRect::include(Cell c) { include(CellRect{c.x, c.y, 1, 1}); }

void CellRect::include(const CellRect& other) {
  if (other.empty()) return;
  if (empty()) {
    *this = other;
    return;
  }
  *this = block(join(extent(x, width), extent(other.x, other.width)),
                join(extent(y, height), extent(other.y, other.height)));
}

CellRect CellRect::grown(int margin) const {
  return block(widen(extent(x, width), margin), widen(extent(y, height), margin));
}

CellRect CellRect::intersection(const CellRect& other) const {
  return block(meet(extent(x, width), extent(other.x, other.width)),
               meet(extent(y, height), extent(other.y, other.height)));
}

bool operator==(const CellRect& a, const CellRect& b) {
  return a.x == b.x && a.y == b.y && a.width == b.width && a.height == b.height;
}

bool operator==(const GridGeometry& a, const GridGeometry& b) {
  return a.resolution == b.resolution && a.origin == b.origin && a.width == b.width && a.height == b.height;
}

CellRect difference(const OccupancyGrid& a, const OccupancyGrid& b, const CellRect& cells) {
  CellRect changed;
  for (int y = cells.y; y < cells.y + cells.height; ++y) {
    const std::int8_t* begin = a.row(y) + cells.x;
    const std::int8_t* end = begin + cells.width;
    const std::int8_t* other = b.row(y) + cells.x;
    if (std::equal(begin, end, other)) continue;  // compares several cells at a time, other than std::mismatch
    const auto first = std::mismatch(begin, end, other).first;
    const auto back = std::mismatch(std::make_reverse_iterator(end), std::make_reverse_iterator(first),
                                    std::make_reverse_iterator(other + cells.width));
    const int x = static_cast<int>(first - a.row(y));
    const int past = static_cast<int>(back.first.base() - a.row(y));
    changed.include(CellRect{x, y, past - x, 1});
  }
  return changed;
}

CellRect difference(const OccupancyGrid& a, const OccupancyGrid& b) { return difference(a, b, a.geometry().rect()); }

}  // namespace frontier_pilot
