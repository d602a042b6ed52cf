#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "frontier_pilot/core/geometry.h"
#include "frontier_pilot/core/grid.h"
#include "frontier_pilot/surfaces/surface_points.h"

namespace frontier_pilot::scan_matching {

/// Maxima of a field over squares: cell (x, y) of level h holds the greatest value in [x, x + 2^h) x [y, y + 2^h), in
/// cell indices of the field; those of higher levels begin below zero. Hess et al., "Real-Time Loop Closure in 2D LIDAR
/// SLAM", ICRA 2016, V-C. It is a copy: the field may change or be destroyed.
class MaxPyramid {
 public:
  /// With the levels 0 (the field itself) to `top`.
  MaxPyramid(const Grid<std::uint8_t>& field, int top);

  const GridGeometry& geometry() const { return levels_.front().grid.geometry(); }
  int top() const { return static_cast<int>(levels_.size()) - 1; }

  struct Level {
    int offset = 0;  ///< index, in x and y, of the first cell (never positive)
    Grid<std::uint8_t> grid;
    /// The value at a cell; 0 outside the grid.
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

/// Half widths around the expected pose.
struct SearchWindow {
  double x = 0.0;    ///< along the map's axes [m]
  double y = 0.0;    ///< [m]
  double yaw = 0.0;  ///< [rad]; pi or more: all directions
};

/// What a deviation from the expected pose costs: weight * min(limit^2, (d / sigma_position)^2 + (a / sigma_yaw)^2)
/// of score. It is bounded, so that the expectation decides only between poses that score nearly alike.
struct SearchPenalty {
  double weight = 0.0;          ///< 0: none
  double limit = 3.0;           ///< in standard deviations
  double sigma_position = 1.0;  ///< [m]
  double sigma_yaw = 1.0;       ///< [rad]
};

/// Poses to be ignored in the search for another peak: those within both bounds of `pose`.
struct SearchExclusion {
  Pose2 pose;
  double distance = 0.0;  ///< [m]
  double angle = 0.0;     ///< [rad]
};

struct SearchRequest {
  Pose2 expected;  ///< T_map_points
  SearchWindow window;
  SearchPenalty penalty;
  std::vector<SearchExclusion> exclusions;
  double min_score = 0.0;  ///< poses with a lower score are not found
  /// With as many levels as the field's pyramid and cells of the same size: positions at which it is 0 are not found.
  /// nullptr: all positions are allowed.
  const MaxPyramid* allowed = nullptr;
  /// Asked for poses that would be the best so far: those for which it is false are not found. Empty: all are accepted.
  std::function<bool(const Pose2&)> accept;
  /// Asked again and again: once it is true, which it then has to stay, the search ends and finds nothing. Empty: it
  /// runs to its end.
  std::function<bool()> stop;
};

struct SearchResult {
  Pose2 pose;              ///< T_map_points
  double score = 0.0;      ///< mean of the likelihoods at the points, 0 ... 1
  double rating = 0.0;     ///< the score less the penalty: what was maximised
  bool on_border = false;  ///< of the window: the true optimum may lie outside
};

/// The pose in the window with the best rating: the exact optimum on a lattice with steps of one cell of the field and
/// of the angle by which the points move one cell in the root mean square. None if no pose reaches
/// `min_score`, or if the search was stopped. Olson, "Real-Time Correlative Scan Matching", ICRA 2009; depth-first
/// branch and bound over the pyramid by Hess et al., ICRA 2016, V. A pyramid with top 0 gives the exhaustive search; a
/// search is fastest with about log2 of the window's width in cells. `points` must not be empty.
std::optional<SearchResult> correlativeSearch(const MaxPyramid& pyramid, const surfaces::SurfacePoints& points,
                                              const SearchRequest& request);

/// The top level that a pyramid should have for `window`; `resolution` is the side of a cell [m].
int pyramidTop(const SearchWindow& window, double resolution);

}  // namespace frontier_pilot::scan_matching
