#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "frontier_pilot/surfaces/surface_points.h"
#include "surfaces/span_finder.h"

namespace frontier_pilot::surfaces {

struct Line {
  Vec2 normal;      ///< of unit length, with either sign
  double variance;  ///< of the points about the line [m^2]
};

/// Fits lines to spans of points by total least squares. It keeps cumulative sums of the moments, so that the cost does
/// not depend on the length of a span.
class LineFitter {
 public:
  explicit LineFitter(const SurfacePoints& points);

  /// The line through a span of points; none if they do not lie on a line.
  std::optional<Line> line(const Span& span, double max_error) const;
  /// As `line`, for a short span: the more points it has, the more they may scatter across the line.
  std::optional<Line> arm(const Span& span, double max_error) const;

 private:
  using Sums = std::array<double, 5>;
  std::optional<Line> fit(const Span& span, double max_error, double elongation) const;

  std::vector<Sums> sums_;
};

}  // namespace frontier_pilot::surfaces
