#pragma once

#include <algorithm>

#include "frontier_pilot/core/grid.h"

namespace frontier_pilot::grids {

/// `cells`, grown to multiples of `step`.
inline CellRect snap(const CellRect& cells, int step) {
  const auto floor_to = [step](int value) { return (value / step - (value % step < 0 ? 1 : 0)) * step; };
  const int x = floor_to(cells.x);
  const int y = floor_to(cells.y);
  return {x, y, floor_to(cells.x + cells.width + step - 1) - x, floor_to(cells.y + cells.height + step - 1) - y};
}

/// A grid of `geometry` with `old` in it, its first cell at `offset`, and `fill` around.
template <class T>
Grid<T> resized(const Grid<T>& old, const GridGeometry& geometry, Cell offset, T fill) {
  Grid<T> grid(geometry, fill);
  for (int y = 0; y < old.height(); ++y) {
    std::copy_n(old.row(y), old.width(), grid.row(y + offset.y) + offset.x);
  }
  return grid;
}

/// A grid that grows where it is needed. Cells are counted from the frame's origin: cell (0, 0) has its lower left
/// corner at (0, 0) [m], and keeps its place when the grid grows.
template <class T>
class GrowingGrid {
 public:
  explicit GrowingGrid(double resolution, T fill = T{}) : fill_(fill) { frame_.resolution = resolution; }

  /// The cell that `point` [m] lies in.
  Cell cellAt(const Vec2& point) const { return frame_.cellAt(point); }
  /// Grows so that `cells` are inside.
  void reserve(const CellRect& cells) {
    CellRect needed = extent_;
    needed.include(cells);
    if (needed == extent_) return;
    resize(snap(needed, kStep));
  }
  bool contains(Cell cell) const { return extent_.contains(cell); }
  /// A cell that is inside.
  T& operator[](Cell cell) { return grid_[Cell{cell.x - extent_.x, cell.y - extent_.y}]; }
  const T& operator[](Cell cell) const { return grid_[Cell{cell.x - extent_.x, cell.y - extent_.y}]; }
  T get(Cell cell) const { return contains(cell) ? (*this)[cell] : fill_; }
  /// What has been reserved so far; cell (0, 0) of it is the lower left one.
  const Grid<T>& grid() const { return grid_; }

 private:
  static constexpr int kStep = 16;

  void resize(const CellRect& cells) {
    GridGeometry geometry = frame_;
    geometry.origin = Vec2(cells.x, cells.y) * frame_.resolution;
    geometry.width = cells.width;
    geometry.height = cells.height;
    grid_ = resized(grid_, geometry, Cell{extent_.x - cells.x, extent_.y - cells.y}, fill_);
    extent_ = cells;
  }

  T fill_;
  GridGeometry frame_;
  CellRect extent_;  ///< the grid's place, in cells from the frame's origin
  Grid<T> grid_;
};

}  // namespace frontier_pilot::grids
