#include "surfaces/line_fitter.h"

#include <algorithm>
#include <cmath>

namespace frontier_pilot::surfaces {
namespace {

constexpr double kElongated = 16.0;  ///< least ratio of the variances along and across a line
constexpr double kDirected = 0.01;   ///< or the greatest variance of its direction [rad^2]

}  // namespace

LineFitter::LineFitter(const SurfacePoints& points) {
  sums_.push_back({});
  for (const SurfacePoint& point : points) {
    const double x = point.position.x();
    const double y = point.position.y();
    const Sums& s = sums_.back();
    sums_.push_back({s[0] + x, s[1] + y, s[2] + x * x, s[3] + x * y, s[4] + y * y});
  }
}

std::optional<Line> LineFitter::line(const Span& span, double max_error) const {
  return fit(span, max_error, kElongated);
}

std::optional<Line> LineFitter::arm(const Span& span, double max_error) const {
  return fit(span, max_error, std::min(kElongated, 1.0 / (kDirected * static_cast<double>(span.size()))));
}

std::optional<Line> LineFitter::fit(const Span& span, double max_error, double elongation) const {
  if (span.size() < 3) return std::nullopt;
  const auto n = static_cast<double>(span.size());
  Sums mean{};
  for (std::size_t k = 0; k < mean.size(); ++k) mean[k] = (sums_[span.last + 1][k] - sums_[span.first][k]) / n;
  const double xx = mean[2] - mean[0] * mean[0];
  const double xy = mean[3] - mean[0] * mean[1];
  const double yy = mean[4] - mean[1] * mean[1];
  const double difference = 0.5 * (xx - yy);
  const double half = std::sqrt(difference * difference + xy * xy);
  const double across = std::max(0.0, 0.5 * (xx + yy) - half);
  const double along = 0.5 * (xx + yy) + half;
  if (across > max_error * max_error || along <= elongation * across) return std::nullopt;
  // The eigenvector of the lesser eigenvalue, from the row of the matrix that is not near zero.
  const Vec2 normal = difference > 0.0 ? Vec2(-xy, half + difference) : Vec2(half - difference, -xy);
  return Line{normal.normalized(), across * n / (n - 2.0)};
}

}  // namespace frontier_pilot::surfaces
