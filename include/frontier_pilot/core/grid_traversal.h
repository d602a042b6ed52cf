#pragma once

#include <cmath>
#include <cstdlib>
#include <limits>

#include "frontier_pilot/core/grid.h"

namespace frontier_pilot {

/// Visits, in order, every cell that the segment `from`-`to` [m] passes through, both ends' cells included, inside the
/// grid or not. `visit(Cell) -> bool`: false stops. Returns whether the end was reached.
/// Amanatides & Woo, "A Fast Voxel Traversal Algorithm for Ray Tracing", Eurographics 1987. Ends must be finite.
template <class Visit>
bool visitCells(const GridGeometry& geometry, const Vec2& from, const Vec2& to, Visit&& visit) {
  Cell cell = geometry.cellAt(from);
  const Cell last = geometry.cellAt(to);
  const int step_x = to.x() > from.x() ? 1 : -1;
  const int step_y = to.y() > from.y() ? 1 : -1;
  const double inf = std::numeric_limits<double>::infinity();
  const double dx = std::abs(to.x() - from.x()) / geometry.resolution;
  const double dy = std::abs(to.y() - from.y()) / geometry.resolution;
  const double delta_x = dx > 0.0 ? 1.0 / dx : inf;
  const double delta_y = dy > 0.0 ? 1.0 / dy : inf;
  const double in_x = (from.x() - geometry.origin.x()) / geometry.resolution - cell.x;
  const double in_y = (from.y() - geometry.origin.y()) / geometry.resolution - cell.y;
  double next_x = dx > 0.0 ? delta_x * (step_x > 0 ? 1.0 - in_x : in_x) : inf;
  double next_y = dy > 0.0 ? delta_y * (step_y > 0 ? 1.0 - in_y : in_y) : inf;
  // Counting border crossings instead of comparing ray parameters guarantees that the walk ends in the last cell.
  int left_x = std::abs(last.x - cell.x);
  int left_y = std::abs(last.y - cell.y);
  while (visit(cell)) {
    if (left_x == 0 && left_y == 0) return true;
    const bool along_x = left_y == 0 || (left_x > 0 && next_x < next_y);
    if (along_x) {
      cell.x += step_x;
      next_x += delta_x;
      --left_x;
    } else {
      cell.y += step_y;
      next_y += delta_y;
      --left_y;
    }
  }
  return false;
}

}  // namespace frontier_pilot
