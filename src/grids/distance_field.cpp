#include "frontier_pilot/grids/distance_field.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <vector>

namespace frontier_pilot::grids {
namespace {

/// For each cell of a window, the number of rows to the nearest obstacle in the same column, at most `cut`.
Grid<std::int32_t> columnDistances(const Grid<std::uint8_t>& obstacle, const CellRect& window, int cut) {
  GridGeometry geometry;
  geometry.width = window.width;
  geometry.height = window.height;
  Grid<std::int32_t> rows(geometry, cut);
  // Row by row, in the order of memory: first upward for the obstacles below, then downward for those above.
  for (int y = 0; y < window.height; ++y) {
    const std::uint8_t* solid = obstacle.row(window.y + y) + window.x;
    std::int32_t* now = rows.row(y);
    const std::int32_t* before = y > 0 ? rows.row(y - 1) : nullptr;
    for (int x = 0; x < window.width; ++x) {
      now[x] = solid[x] != 0 ? 0 : (before != nullptr ? std::min(before[x] + 1, cut) : cut);
    }
  }
  for (int y = window.height - 2; y >= 0; --y) {
    std::int32_t* now = rows.row(y);
    const std::int32_t* above = rows.row(y + 1);
    for (int x = 0; x < window.width; ++x) now[x] = std::min(now[x], above[x] + 1);
  }
  return rows;
}

std::int64_t squareOf(std::int64_t cells) { return cells * cells; }

/// The lower envelope of the parabolas f(q) + (x - q)^2: the intervals in which each of them is the lowest.
class LowerEnvelope {
 public:
  explicit LowerEnvelope(int size) : apex_(static_cast<std::size_t>(size)), from_(static_cast<std::size_t>(size) + 1) {}

  void build(const std::int32_t* rows, int size, std::int32_t cut) {
    count_ = 0;
    for (int q = 0; q < size; ++q) {
      if (rows[q] < cut) push(q, rows);
    }
  }
  bool empty() const { return count_ == 0; }

  /// Squared distances [cells^2] at 0 ... size - 1, in order.
  template <class Emit>
  void sample(const std::int32_t* rows, int size, Emit emit) const {
    std::size_t k = 0;
    for (int x = 0; x < size; ++x) {
      while (k + 1 < count_ && from_[k + 1] < static_cast<double>(x)) ++k;
      emit(x, squareOf(x - apex_[k]) + squareOf(rows[apex_[k]]));
    }
  }

 private:
  void push(int q, const std::int32_t* rows) {
    double start = -std::numeric_limits<double>::infinity();
    while (count_ > 0) {
      start = crossing(apex_[count_ - 1], q, rows);
      if (start > from_[count_ - 1]) break;
      --count_;
    }
    if (count_ == 0) start = -std::numeric_limits<double>::infinity();
    apex_[count_] = q;
    from_[count_++] = start;
  }

  /// Where the parabola of `q` becomes lower than the one of `p` < `q`.
  static double crossing(int p, int q, const std::int32_t* rows) {
    const std::int64_t fp = squareOf(rows[p]) + squareOf(p);
    const std::int64_t fq = squareOf(rows[q]) + squareOf(q);
    return static_cast<double>(fq - fp) / (2.0 * (q - p));
  }

  std::vector<int> apex_;
  std::vector<double> from_;
  std::size_t count_ = 0;
};

/// Converts a squared distance [cells^2] to [m], by a table for short distances, which is faster than a square root.
class SquaredCellsToMetres {
 public:
  SquaredCellsToMetres(int cut, double resolution, double max_distance) : resolution_(resolution), max_(max_distance) {
    const int side = std::min(cut, 128);
    table_.reserve(static_cast<std::size_t>(side * side) + 1);
    for (int i = 0; i <= side * side; ++i) table_.push_back(metres(i));
  }
  float operator()(std::int64_t squared) const {
    const auto i = static_cast<std::size_t>(squared);
    return i < table_.size() ? table_[i] : metres(squared);
  }

 private:
  float metres(std::int64_t squared) const {
    return static_cast<float>(std::min(std::sqrt(static_cast<double>(squared)) * resolution_, max_));
  }

  double resolution_;
  double max_;
  std::vector<float> table_;
};

}  // namespace

DistanceField::DistanceField(const Grid<std::uint8_t>& obstacle, double max_distance)
    : max_distance_(max_distance), distance_(obstacle.geometry(), static_cast<float>(max_distance)) {
  if (!(max_distance > 0.0)) throw std::invalid_argument("distance field: the maximum must be positive");
  compute(obstacle, geometry().rect());
}

void DistanceField::update(const Grid<std::uint8_t>& obstacle, const CellRect& changed) {
  if (obstacle.geometry() != geometry()) throw std::invalid_argument("distance field: the geometry has changed");
  if (changed.empty()) return;
  const int reach = static_cast<int>(std::ceil(max_distance_ / geometry().resolution));
  compute(obstacle, changed.grown(reach).intersection(geometry().rect()));
}

void DistanceField::compute(const Grid<std::uint8_t>& obstacle, const CellRect& window) {
  if (window.empty()) return;
  const int reach = static_cast<int>(std::ceil(max_distance_ / geometry().resolution));
  // Only obstacles within `reach` of the window can affect it.
  const CellRect source = window.grown(reach).intersection(geometry().rect());
  const int cut = std::min(reach, source.width + source.height) + 1;
  const Grid<std::int32_t> rows = columnDistances(obstacle, source, cut);
  const SquaredCellsToMetres metres(cut, geometry().resolution, max_distance_);
  const auto far = static_cast<float>(max_distance_);
  const int offset = window.x - source.x;
  LowerEnvelope envelope(source.width);
  for (int y = window.y; y < window.y + window.height; ++y) {
    const std::int32_t* line = rows.row(y - source.y);
    float* out = distance_.row(y) + window.x;
    envelope.build(line, source.width, cut);
    if (envelope.empty()) {
      std::fill(out, out + window.width, far);
      continue;
    }
    envelope.sample(line, source.width, [&](int x, std::int64_t squared) {
      if (x < offset || x >= offset + window.width) return;
      out[x - offset] = metres(squared);
    });
  }
}

}  // namespace frontier_pilot::grids
