#include "scan_matching/likelihood_grid.h"

#include <algorithm>
#include <cmath>

namespace frontier_pilot::scan_matching {
namespace {

constexpr int kPhases = 16;      ///< positions of a point in its cell that are distinguished, along one axis
constexpr double kSigmas = 2.5;  ///< the field is zero farther than this from all points, along either axis

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

}  // namespace frontier_pilot::scan_matching
