#include <algorithm>
#include <cstdint>
#include <vector>

#include "frontier_pilot/scan_matching/correlative_search.h"

namespace frontier_pilot::scan_matching {
namespace {

using Bytes = Grid<std::uint8_t>;

/// Maxima of pairs of cells that are `step` apart in a row. `out` is `step` cells longer than `in` and begins `step`
/// earlier; outside `in` the values are zero.
void maxOfRow(const std::uint8_t* in, int width, int step, std::uint8_t* out) {
  std::copy_n(in, std::min(step, width), out);
  std::fill(out + std::min(step, width), out + step, std::uint8_t{0});
  for (int i = step; i < width; ++i) out[i] = std::max(in[i - step], in[i]);
  for (int i = std::max(step, width); i < width + step; ++i) out[i] = in[i - step];
}

void maxOfRows(const std::uint8_t* a, const std::uint8_t* b, int width, std::uint8_t* out) {
  for (int i = 0; i < width; ++i) out[i] = std::max(a[i], b[i]);
}

Bytes sized(int width, int height, double resolution) {
  GridGeometry geometry;
  geometry.resolution = resolution;
  geometry.width = width;
  geometry.height = height;
  return Bytes(geometry);
}

/// Level h + 1 from level h, whose squares have sides of `step` cells.
MaxPyramid::Level coarser(const MaxPyramid::Level& fine, int step) {
  const int width = fine.grid.width();
  const int height = fine.grid.height();
  Bytes wide = sized(width + step, height, fine.grid.resolution());
  for (int y = 0; y < height; ++y) maxOfRow(fine.grid.row(y), width, step, wide.row(y));
  MaxPyramid::Level coarse{fine.offset - step, sized(width + step, height + step, fine.grid.resolution())};
  const std::vector<std::uint8_t> nothing(static_cast<std::size_t>(width + step), 0);
  const auto row = [&](int y) { return y >= 0 && y < height ? wide.row(y) : nothing.data(); };
  for (int y = 0; y < height + step; ++y) maxOfRows(row(y - step), row(y), width + step, coarse.grid.row(y));
  return coarse;
}

}  // namespace

MaxPyramid::MaxPyramid(const Bytes& field, int top) {
  levels_.push_back({0, field});
  for (int h = 1; h <= top; ++h) levels_.push_back(coarser(levels_.back(), 1 << (h - 1)));
}

}  // namespace frontier_pilot::scan_matching
