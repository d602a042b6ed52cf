#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <vector>

#include "frontier_pilot/core/geometry.h"

namespace frontier_pilot {

/// Column and row of a cell; (0, 0) is the lower left one.
struct Cell {
  int x = 0;
  int y = 0;
};
inline bool operator==(Cell a, Cell b) { return a.x == b.x && a.y == b.y; }
inline bool operator!=(Cell a, Cell b) { return !(a == b); }

/// A block of cells [x, x + width) x [y, y + height). Empty if a side is not positive. Its members never overflow,
/// whatever the values, because they also check input from outside: a block that would extend beyond the range of int
/// is clipped to it. [FLT-1]
struct CellRect {
  int x = 0;
  int y = 0;
  int width = 0;
  int height = 0;

  bool empty() const { return width <= 0 || height <= 0; }
  bool contains(Cell c) const {
    return c.x >= x && c.y >= y && c.x < std::int64_t{x} + width && c.y < std::int64_t{y} + height;
  }
  /// Grows so that `c` is inside.
  void include(Cell c);
  /// Grows so that all of `other` is inside.
  void include(const CellRect& other);
  /// The same block, `margin` cells wider on each side.
  CellRect grown(int margin) const;
  /// The cells that lie in both.
  CellRect intersection(const CellRect& other) const;
};
bool operator==(const CellRect& a, const CellRect& b);

/// How the cells of a grid lie in its frame: axis-aligned squares, row by row from the lower left corner.
struct GridGeometry {
  double resolution = 0.05;    ///< side of a cell [m]
  Vec2 origin = Vec2::Zero();  ///< lower left corner of cell (0, 0) [m]
  int width = 0;               ///< [cells]
  int height = 0;              ///< [cells]

  std::size_t size() const { return static_cast<std::size_t>(width) * static_cast<std::size_t>(height); }
  CellRect rect() const { return {0, 0, width, height}; }
  bool contains(Cell c) const { return c.x >= 0 && c.y >= 0 && c.x < width && c.y < height; }
  /// The cell that `point` [m] lies in, even outside of the grid. `point` must be finite and within 10^9 cells of the
  /// origin.
  Cell cellAt(const Vec2& point) const {
    return {static_cast<int>(std::floor((point.x() - origin.x()) / resolution)),
            static_cast<int>(std::floor((point.y() - origin.y()) / resolution))};
  }
  /// The centre of a cell [m].
  Vec2 centre(Cell c) const { return {origin.x() + (c.x + 0.5) * resolution, origin.y() + (c.y + 0.5) * resolution}; }
  std::size_t index(Cell c) const {
    return static_cast<std::size_t>(c.y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(c.x);
  }
  Cell cell(std::size_t index) const {
    return {static_cast<int>(index % static_cast<std::size_t>(width)),
            static_cast<int>(index / static_cast<std::size_t>(width))};
  }
};
bool operator==(const GridGeometry& a, const GridGeometry& b);
inline bool operator!=(const GridGeometry& a, const GridGeometry& b) { return !(a == b); }

/// A dense raster over a GridGeometry. Indexing is unchecked; `get` returns a default outside of the grid.
template <class T>
class Grid {
 public:
  Grid() = default;
  explicit Grid(const GridGeometry& geometry, T fill = T{}) : geometry_(geometry), cells_(geometry.size(), fill) {}
  /// Takes `cells`, stored row by row. Throws std::invalid_argument when their number does not match the geometry.
  Grid(const GridGeometry& geometry, std::vector<T> cells) : geometry_(geometry), cells_(std::move(cells)) {
    if (cells_.size() != geometry_.size()) throw std::invalid_argument("grid: number of cells and geometry differ");
  }

  const GridGeometry& geometry() const { return geometry_; }
  int width() const { return geometry_.width; }
  int height() const { return geometry_.height; }
  double resolution() const { return geometry_.resolution; }
  bool contains(Cell c) const { return geometry_.contains(c); }
  bool empty() const { return cells_.empty(); }
  std::size_t size() const { return cells_.size(); }

  T& operator[](Cell c) { return cells_[geometry_.index(c)]; }
  const T& operator[](Cell c) const { return cells_[geometry_.index(c)]; }
  T& operator[](std::size_t index) { return cells_[index]; }
  const T& operator[](std::size_t index) const { return cells_[index]; }
  T get(Cell c, T outside) const { return contains(c) ? (*this)[c] : outside; }

  T* row(int y) { return cells_.data() + geometry_.index({0, y}); }
  const T* row(int y) const { return cells_.data() + geometry_.index({0, y}); }
  std::vector<T>& cells() { return cells_; }
  const std::vector<T>& cells() const { return cells_; }

 private:
  GridGeometry geometry_;
  std::vector<T> cells_;
};

/// Occupancy as in nav_msgs/OccupancyGrid: -1 unknown, 0 (free) ... 100 (occupied).
using OccupancyGrid = Grid<std::int8_t>;

/// The smallest block that contains every cell of `cells`, which must be inside, in which two grids of the same
/// geometry differ.
CellRect difference(const OccupancyGrid& a, const OccupancyGrid& b, const CellRect& cells);
/// The same for all cells.
CellRect difference(const OccupancyGrid& a, const OccupancyGrid& b);

constexpr std::int8_t kUnknown = -1;
constexpr std::int8_t kFree = 0;
constexpr std::int8_t kOccupied = 100;

inline bool isUnknown(std::int8_t value) { return value < 0; }
inline bool isFree(std::int8_t value) { return value >= 0 && value < 50; }
inline bool isOccupied(std::int8_t value) { return value >= 50; }

}  // namespace frontier_pilot
