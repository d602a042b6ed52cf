#pragma once

#include <cstdint>
#include <vector>

#include "frontier_pilot/core/grid.h"
#include "frontier_pilot/grids/growing_grid.h"
#include "frontier_pilot/scan_matching/parameters.h"

namespace frontier_pilot::scan_matching {

/// A likelihood field: 255 exp(-d^2 / (2 sigma^2)), where d is the distance from the cell's centre to the nearest
/// point. Thrun, Burgard & Fox, "Probabilistic Robotics", 6.4. It grows where points are added.
class LikelihoodGrid {
 public:
  explicit LikelihoodGrid(const LikelihoodParameters& parameters = {});

  /// `points` [m] in the field's frame, finite.
  void add(const std::vector<Vec2>& points);

  /// Empty until the first point.
  const Grid<std::uint8_t>& grid() const { return field_.grid(); }
  const LikelihoodParameters& parameters() const { return parameters_; }

 private:
  void stamp(const Vec2& point);
  const float* profile(double phase) const;

  LikelihoodParameters parameters_;
  int reach_;                    ///< how far from a point the field is not zero [cells]
  std::vector<float> profiles_;  ///< the Gaussian at cell centres, for each subcell position of the point
  grids::GrowingGrid<std::uint8_t> field_;
};

}  // namespace frontier_pilot::scan_matching
