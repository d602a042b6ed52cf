#include "exploration/limits/allowed_cells.h"

#include <algorithm>
#include <cmath>

namespace frontier_pilot::exploration {
namespace {

/// Where the horizontal line at `y` crosses the polygon's sides, from left to right [m]. A side contains its lower end
/// and not its upper one, so that a line through a corner crosses as often as one beside it.
void crossings(const std::vector<Vec2>& corners, double y, std::vector<double>& at) {
  at.clear();
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec2& a = corners[i];
    const Vec2& b = corners[(i + 1) % corners.size()];
    if ((a.y() > y) != (b.y() > y)) at.push_back(a.x() + (y - a.y()) * (b.x() - a.x()) / (b.y() - a.y()));
  }
  std::sort(at.begin(), at.end());
}

/// The first column whose centre is not left of `x` [m]; the grid's width if there is none.
int columnFrom(double x, const GridGeometry& geometry) {
  const double column = std::ceil((x - geometry.origin.x()) / geometry.resolution - 0.5);
  return static_cast<int>(std::clamp(column, 0.0, static_cast<double>(geometry.width)));
}

}  // namespace

void AllowedCells::cover(const GridGeometry& geometry) {
  outside_ = {};
  if (bounds_.empty()) return;
  outside_ = Grid<std::uint8_t>(geometry, bounds_.stay_within.empty() ? 0 : 1);
  row_.assign(static_cast<std::size_t>(geometry.width), 0);
  fill(bounds_.stay_within, 0);
  for (const std::vector<Vec2>& area : bounds_.keep_out) fill(area, 1);
}

/// Sets the cells whose centre lies in the polygon, row by row between its sides.
void AllowedCells::fill(const std::vector<Vec2>& corners, std::uint8_t value) {
  const GridGeometry& geometry = outside_.geometry();
  std::vector<double> at;
  for (int y = 0; y < geometry.height; ++y) {
    crossings(corners, geometry.centre({0, y}).y(), at);
    for (std::size_t i = 0; i + 1 < at.size(); i += 2) {
      const int begin = columnFrom(at[i], geometry);
      const int end = columnFrom(at[i + 1], geometry);
      std::fill_n(outside_.row(y) + begin, end - begin, value);
    }
  }
}

const std::int8_t* AllowedCells::shown(const std::int8_t* row, int y, int begin, int end) {
  if (all()) return row;
  const std::uint8_t* outside = outside_.row(y);
  for (int x = begin; x < end; ++x) row_[static_cast<std::size_t>(x)] = outside[x] != 0 ? kOccupied : row[x];
  return row_.data();
}

}  // namespace frontier_pilot::exploration
