#pragma once

#include "frontier_pilot/core/grid.h"

namespace frontier_pilot::grids {

/// One value per cell of the square that extends `reach` cells to every side of `centre`: storage for a search that
/// stays near a cell. Cells have their indices on the underlying grid. Access outside of the square is undefined.
template <class T>
class CellWindow {
 public:
  CellWindow(Cell centre, int reach, T fill)
      : low_{centre.x - reach, centre.y - reach}, values_(square(2 * reach + 1), fill) {}

  T& operator[](Cell cell) { return values_[local(cell)]; }
  const T& operator[](Cell cell) const { return values_[local(cell)]; }

 private:
  static GridGeometry square(int side) {
    GridGeometry geometry;
    geometry.width = geometry.height = side;
    return geometry;
  }
  Cell local(Cell cell) const { return {cell.x - low_.x, cell.y - low_.y}; }

  Cell low_;
  Grid<T> values_;
};

}  // namespace frontier_pilot::grids
