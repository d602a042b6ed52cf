#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "frontier_pilot/core/grid.h"

namespace frontier_pilot::grids {

// In a "canonical" frame the ray's longer axis is x, and both components of its direction are positive. Eight such
// frames cover the circle: either axis may be the longer one, and each axis may be mirrored. Canonical grids have a
// ring of solid cells around them, so that a walk needs no border check; cell (0, 0) of the grid becomes (1, 1).
constexpr int kOctants = 8;

// Slopes (short axis over long axis) are divided into the classes [0, 1/8), [1/8, 1/4), [1/4, 1/2) and [1/2, 1]. Except
// in the first, the greatest slope of a class is at most twice its smallest, so that each leap towards a wall beside
// the ray at least halves the distance to it.
constexpr int kSlopes = 4;
constexpr int kFlattest = 1 << (kSlopes - 1);

constexpr int kMaxLeap = 254;

/// The canonical cells of an octant: the lengths of their free runs, and from those the leaps of each class of slopes.
/// A column is contiguous in memory: rays from one place leap to the same column, and so to the same cache line.
class LeapBuilder {
 public:
  LeapBuilder(const Grid<std::uint8_t>& solid, bool steep, bool mirror_x, bool mirror_y)
      : columns_((steep ? solid.height() : solid.width()) + 2),
        stride_((steep ? solid.width() : solid.height()) + 2),
        runs_(static_cast<std::size_t>((columns_ + kTailColumns) * stride_)) {
    for (int y = 0; y < solid.height(); ++y) {
      for (int x = 0; x < solid.width(); ++x) {
        const int cx = mirror_x ? solid.width() - x : x + 1;
        const int cy = mirror_y ? solid.height() - y : y + 1;
        runs_[steep ? at(cy, cx) : at(cx, cy)] = solid[{x, y}] == 0;
      }
    }
    countRuns();
  }

  // Fills a plane. kTailColumns columns beyond its end must be readable; their content does not matter.
  void fill(int slope_class, std::uint8_t* leaps) const {
    for (std::ptrdiff_t column = columns_ - 2; column > 0; --column) {
      if (slope_class == 0) {
        fillFlatColumn(column, leaps);
      } else {
        fillSlopedColumn(column, kFlattest >> slope_class, leaps);
      }
    }
  }

  static constexpr std::ptrdiff_t kTailColumns = kFlattest + 1;

 private:
  std::size_t at(std::ptrdiff_t column, std::ptrdiff_t row) const {
    return static_cast<std::size_t>(column * stride_ + row);
  }

  static std::uint8_t plus(std::uint8_t leap, int columns) {
    return static_cast<std::uint8_t>(std::min(leap + columns, kMaxLeap));
  }
  static std::uint8_t leapOf(std::uint8_t stored) { return static_cast<std::uint8_t>(stored - (stored > 0)); }
  static std::uint8_t stored(std::uint8_t leap, std::uint8_t run) {
    return static_cast<std::uint8_t>(leap + (run > 0));
  }

  void countRuns() {
    for (std::ptrdiff_t column = columns_ - 2; column > 0; --column) {
      std::uint8_t* run = runs_.data() + at(column, 0);
      for (std::ptrdiff_t row = 0; row < stride_; ++row) run[row] = run[row] != 0 ? plus(run[row + stride_], 1) : 0;
    }
  }

  // Slopes in [0, 1/m): in the first m columns a ray from a cell stays in its row and the one above, and it enters
  // column m in one of these two. Reads beyond the last column cannot matter: the run is shorter than that.
  void fillFlatColumn(std::ptrdiff_t column, std::uint8_t* leaps) const {
    constexpr int m = kFlattest;
    const std::uint8_t* run = runs_.data() + at(column, 0);
    const std::uint8_t* next = leaps + at(column + m, 0);
    std::uint8_t* here = leaps + at(column, 0);
    for (std::ptrdiff_t row = 1; row < stride_ - 1; ++row) {
      const std::uint8_t near = std::min(run[row], run[row + 1]);
      const std::uint8_t far = plus(std::min(leapOf(next[row]), leapOf(next[row + 1])), m);
      here[row] = stored(std::min(near, far), run[row]);
    }
  }

  // Slopes in [1/2m, 1/m]: in the first m columns as above; in the next m columns a ray may also reach the row above
  // those two; it enters column 2m one or two rows up.
  void fillSlopedColumn(std::ptrdiff_t column, int m, std::uint8_t* leaps) const {
    const std::uint8_t* run = runs_.data() + at(column, 0);
    const std::uint8_t* run_later = runs_.data() + at(column + m, 0);
    const std::uint8_t* next = leaps + at(column + m + m, 0);
    std::uint8_t* here = leaps + at(column, 0);
    for (std::ptrdiff_t row = 1; row < stride_ - 1; ++row) {
      const std::uint8_t near = std::min(std::min(run[row], run[row + 1]), plus(run_later[row + 2], m));
      const std::uint8_t far = plus(std::min(leapOf(next[row + 1]), leapOf(next[row + 2])), 2 * m);
      here[row] = stored(std::min(near, far), run[row]);
    }
  }

  std::ptrdiff_t columns_;
  std::ptrdiff_t stride_;
  std::vector<std::uint8_t> runs_;
};

}  // namespace frontier_pilot::grids
