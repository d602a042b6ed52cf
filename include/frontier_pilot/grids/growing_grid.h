#pragma once

#include <algorithm>

#include "frontier_pilot/core/grid.h"

namespace frontier_pilot::grids {

/// The smallest block that contains `cells` and whose borders are multiples of `step`.
inline CellRect snap(const CellRect& cells, int step) {
  const auto floor_to = [step](int value) { return (value / step - (value % step < 0 ? 1 : 0)) * step; };
  const int x = floor_to(cells.x);
  const int y = floor_to(cells.y);
  return {x, y, floor_to(cells.x + cells.width + step - 1) - x, floor_to(cells.y + cells.height + step - 1) - y};
}

/// A grid of `geometry` that contains `old`, whose cell (0, 0) comes to `offset`; all other cells are `fill`.
template <class T>
Grid<T> resized(const Grid<T>& old, const GridGeometry& geometry, Cell offset, T fill) {
  Grid<T> grid(geometry, fill);
  for (int y = 0; y < old.height(); ++y) {
    std::copy_n(old.row(y), old.width(), grid.row(y + offset.y) + offset.x);
  }
  return grid;
}

/// A grid that grows as needed. Cells are counted from the frame's origin: cell (0, 0) has its lower left corner at
/// (0, 0) [m], and the indices of cells do not change when the grid grows.
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
  /// `cell` must be inside.
  T& operator[](Cell cell) { return grid_[Cell{cell.x - extent_.x, cell.y - extent_.y}]; }
  const T& operator[](Cell cell) const { return grid_[Cell{cell.x - extent_.x, cell.y - extent_.y}]; }
  T get(Cell cell) const { return contains(cell) ? (*this)[cell] : fill_; }
  /// All cells reserved so far, as an ordinary grid: its cell (0, 0) is the lower left one of them.
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
  CellRect extent_;  ///< where `grid_` lies, in cells from the frame's origin
  Grid<T> grid_;
};

}  // namespace frontier_pilot::grids
