#include "frontier_pilot/scan_matching/likelihood_grid.h"

#include <algorithm>
#include <cmath>

namespace frontier_pilot::scan_matching {
namespace {

constexpr int kPhases = 16;      ///< places in a cell, along one axis, that are told apart
constexpr double kSigmas = 2.5;  ///< farther than this nothing is felt

using Bytes = Grid<std::uint8_t>;

/// Maxima of pairs of cells that are `step` apart, along a row. `out` is `step` longer than `in` and begins `step`
/// earlier; outside of `in` there are zeros.
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

LikelihoodGrid::LikelihoodGrid(const LikelihoodParameters& parameters)
    : parameters_(parameters),
      reach_(std::max(1, static_cast<int>(std::lround(kSigmas * parameters.sigma / parameters.resolution)))),
      field_(parameters.resolution) {
  const double sigma = parameters.sigma / parameters.resolution;
  for (int phase = 0; phase < kPhases; ++phase) {
    const double place = (phase + 0.5) / kPhases - 0.5;
    for (int i = -reach_; i <= reach_; ++i) {
      profiles_.push_back(static_cast<float>(std::exp(-0.5 * std::pow((i - place) / sigma, 2))));
    }
  }
}

void LikelihoodGrid::add(const std::vector<Vec2>& points) {
  CellRect cells;
  for (const Vec2& point : points) cells.include(field_.cellAt(point));
  if (cells.empty()) return;
  field_.reserve(cells.grown(reach_));
  for (const Vec2& point : points) stamp(point);
}

const float* LikelihoodGrid::profile(double phase) const {
  const int row = std::clamp(static_cast<int>(phase * kPhases), 0, kPhases - 1);
  return profiles_.data() + static_cast<std::ptrdiff_t>(row) * (2 * reach_ + 1);
}

void LikelihoodGrid::stamp(const Vec2& point) {
  const Cell cell = field_.cellAt(point);
  const Vec2 scaled = point / parameters_.resolution;
  const float* along_x = profile(scaled.x() - cell.x);
  const float* along_y = profile(scaled.y() - cell.y);
  const int width = 2 * reach_ + 1;
  for (int j = 0; j < width; ++j) {
    std::uint8_t* row = &field_[{cell.x - reach_, cell.y - reach_ + j}];
    const float peak = 255.0F * along_y[j];
    for (int i = 0; i < width; ++i) {
      const float rounded = peak * along_x[i] + 0.5F;
      row[i] = std::max(row[i], static_cast<std::uint8_t>(rounded));
    }
  }
}

MaxPyramid::MaxPyramid(const Bytes& field, int top) {
  levels_.push_back({0, field});
  for (int h = 1; h <= top; ++h) levels_.push_back(coarser(levels_.back(), 1 << (h - 1)));
}

}  // namespace frontier_pilot::scan_matching
