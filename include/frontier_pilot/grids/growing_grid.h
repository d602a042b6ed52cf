#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

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

/// A grid that grows as needed and whose memory follows the cells that are used: a tile of kSide x kSide cells is
/// allocated when one of them is first written. Cells are counted from the frame's origin. What has been reserved costs
/// a pointer for each tile.
template <class T>
class TiledGrid {
 public:
  static constexpr int kSide = 64;  ///< of a tile [cells]: 3.2 m in cells of 5 cm
  using Tile = std::array<T, static_cast<std::size_t>(kSide) * kSide>;

  explicit TiledGrid(T fill = T{}) : fill_(fill) {}

  /// Grows so that `cells` can be used.
  void reserve(const CellRect& cells) {
    CellRect needed = extent_;
    needed.include(cells);
    needed = snap(needed, kSide);
    if (needed == extent_) return;
    std::vector<std::unique_ptr<Tile>> old =
        std::exchange(tiles_, std::vector<std::unique_ptr<Tile>>(static_cast<std::size_t>(needed.width / kSide) *
                                                                 static_cast<std::size_t>(needed.height / kSide)));
    const CellRect before = std::exchange(extent_, needed);
    tiles_in_row_ = extent_.width >> kShift;
    first_ = std::ptrdiff_t{extent_.y >> kShift} * tiles_in_row_ + (extent_.x >> kShift);
    std::size_t next = 0;
    for (int y = before.y; y < before.y + before.height; y += kSide) {
      for (int x = before.x; x < before.x + before.width; x += kSide) tiles_[indexOf({x, y})] = std::move(old[next++]);
    }
  }
  /// What has been reserved: whole tiles.
  const CellRect& extent() const { return extent_; }

  /// The value of `cell`, which must be reserved.
  T operator[](Cell cell) const {
    const Tile* tile = tiles_[indexOf(cell)].get();
    return tile == nullptr ? fill_ : (*tile)[placeOf(cell)];
  }
  T get(Cell cell) const { return extent_.contains(cell) ? (*this)[cell] : fill_; }
  /// The same to be written, where its tile is allocated; otherwise nullptr. `cell` must be reserved.
  T* find(Cell cell) {
    Tile* tile = tiles_[indexOf(cell)].get();
    return tile == nullptr ? nullptr : &(*tile)[placeOf(cell)];
  }
  /// The same, and allocates the tile.
  T& at(Cell cell) {
    std::unique_ptr<Tile>& tile = tiles_[indexOf(cell)];
    if (!tile) {
      tile = std::make_unique<Tile>();
      tile->fill(fill_);
      ++allocated_;
    }
    return (*tile)[placeOf(cell)];
  }
  /// The tile that holds `cell`, row by row; nullptr where none is allocated. `cell` may be anywhere.
  const Tile* tile(Cell cell) const { return extent_.contains(cell) ? tiles_[indexOf(cell)].get() : nullptr; }

  /// The number of allocated tiles.
  std::size_t tileCount() const { return allocated_; }
  /// The memory that it takes [bytes].
  std::size_t memory() const { return allocated_ * sizeof(Tile) + tiles_.size() * sizeof(tiles_.front()); }
  /// Frees all tiles. What has been reserved stays so.
  void clear() {
    for (auto& tile : tiles_) tile.reset();
    allocated_ = 0;
  }

 private:
  static constexpr int kShift = 6;
  static_assert(1 << kShift == kSide);

  std::size_t indexOf(Cell cell) const {
    return static_cast<std::size_t>(std::ptrdiff_t{cell.y >> kShift} * tiles_in_row_ + (cell.x >> kShift) - first_);
  }
  /// The borders of tiles are multiples of kSide, and the last bits of negative numbers count upwards as well.
  static std::size_t placeOf(Cell cell) {
    return (static_cast<std::size_t>(cell.y) % kSide) * kSide + static_cast<std::size_t>(cell.x) % kSide;
  }

  T fill_;
  CellRect extent_;  ///< [cells], whole tiles
  std::ptrdiff_t tiles_in_row_ = 0;
  std::ptrdiff_t first_ = 0;  ///< index of the first tile if that of the frame's origin were 0
  std::vector<std::unique_ptr<Tile>> tiles_;
  std::size_t allocated_ = 0;
};

}  // namespace frontier_pilot::grids
