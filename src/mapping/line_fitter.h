#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "frontier_pilot/mapping/span_finder.h"
#include "frontier_pilot/mapping/surface_points.h"

namespace frontier_pilot {

struct Line {
  Vec2 normal;      ///< unit, either way round
  double variance;  ///< of the points from it [m^2]
};

/// Fits lines to spans of points by total least squares. It keeps the sums of the moments of the first n points, so
/// that any span costs the same.
class LineFitter {
 public:
  explicit LineFitter(const SurfacePoints& points);

  /// The line through a span; none if its points are none.
  std::optional<Line> line(const Span& span, double max_error) const;
  /// The same for a short one, that may be as thick as long if it has points enough to say where it leads.
  std::optional<Line> arm(const Span& span, double max_error) const;

 private:
  using Sums = std::array<double, 5>;
  std::optional<Line> fit(const Span& span, double max_error, double elongation) const;

  std::vector<Sums> sums_;
};

}  // namespace frontier_pilot
