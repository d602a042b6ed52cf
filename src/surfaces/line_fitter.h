#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "frontier_pilot/surfaces/surface_points.h"
#include "surfaces/span_finder.h"

namespace frontier_pilot::surfaces {

struct Line {
  Vec2 normal;      ///< unit, either way round
  double variance;  ///< of the points from it [m^2]
};

/// Fits lines to spans of points by total least squares. It keeps the sums of the moments of the first n points, so
/// that any span costs the same.
class LineFitter {
 public:
  explicit LineFitter(const SurfacePoints& points);

  /// The line through a span of points; none if they do not lie on a line.
  std::optional<Line> line(const Span& span, double max_error) const;
  /// As `line`, for a short span: its points may scatter as far across the line as along it when they are many.
  std::optional<Line> arm(const Span& span, double max_error) const;

 private:
  using Sums = std::array<double, 5>;
  std::optional<Line> fit(const Span& span, double max_error, double elongation) const;

  std::vector<Sums> sums_;
};

}  // namespace frontier_pilot::surfaces
