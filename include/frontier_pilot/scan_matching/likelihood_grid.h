#pragma once

#include <cstdint>
#include <vector>

#include "frontier_pilot/core/grid.h"
#include "frontier_pilot/core/parameters.h"
#include "frontier_pilot/grids/growing_grid.h"

namespace frontier_pilot::scan_matching {

struct LikelihoodParameters {
  double resolution = 0.05;  ///< side of a cell [m]
  double sigma = 0.06;       ///< standard deviation of the Gaussian around each point [m]

  template <class Visitor>
  void describe(Visitor& v) {
    v.fixed({"resolution", "sigma"});
  }
};

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
  int reach_;                    ///< how far a point is felt [cells]
  std::vector<float> profiles_;  ///< the Gaussian at the cells' centres, for each place of the point in its cell
  grids::GrowingGrid<std::uint8_t> field_;
};

/// Maxima of a field over squares: cell (x, y) of level h holds the greatest value in [x, x + 2^h) x [y, y + 2^h), in
/// the field's own cell numbers, which may begin below zero. Hess et al., "Real-Time Loop Closure in 2D LIDAR SLAM",
/// ICRA 2016, V-C. A copy: the field may change or go, and another thread may search in it.
class MaxPyramid {
 public:
  /// With the levels 0 (the field itself) to `top`.
  MaxPyramid(const Grid<std::uint8_t>& field, int top);

  const GridGeometry& geometry() const { return levels_.front().grid.geometry(); }
  int top() const { return static_cast<int>(levels_.size()) - 1; }

  struct Level {
    int offset = 0;  ///< the number, in both directions, of the first cell (never positive)
    Grid<std::uint8_t> grid;
    /// 0 outside.
    std::uint8_t at(int x, int y) const {
      const auto column = static_cast<unsigned>(x - offset);
      const auto row = static_cast<unsigned>(y - offset);
      if (column >= static_cast<unsigned>(grid.width()) || row >= static_cast<unsigned>(grid.height())) return 0;
      return grid.cells()[static_cast<std::size_t>(row) * static_cast<std::size_t>(grid.width()) + column];
    }
  };
  const Level& level(int h) const { return levels_[static_cast<std::size_t>(h)]; }

 private:
  std::vector<Level> levels_;
};

}  // namespace frontier_pilot::scan_matching
