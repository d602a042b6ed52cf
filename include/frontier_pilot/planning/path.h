#pragma once

#include <vector>

#include "frontier_pilot/core/geometry.h"

namespace frontier_pilot::planning {

/// A polyline in the map frame, measured along its length [m].
class Path {
 public:
  Path() = default;
  /// Points that repeat their predecessor are dropped.
  explicit Path(const std::vector<Vec2>& points);

  bool empty() const { return points_.empty(); }
  const std::vector<Vec2>& points() const { return points_; }
  const Vec2& goal() const { return points_.back(); }
  /// Distance along the path of the point `i`.
  double arcLength(std::size_t i) const { return along_[i]; }
  double length() const { return along_.empty() ? 0.0 : along_.back(); }

  /// The point at `s` along the path, at its nearer end if `s` is beyond. Must not be empty.
  Vec2 at(double s) const;
  /// Where between `from` and `to` along the path it comes nearest to `point`; the earlier one of equals.
  double project(const Vec2& point, double from, double to) const;

  /// The part from `s` on.
  Path from(double s) const;
  /// The same line with a point at least every `spacing`.
  std::vector<Vec2> sampled(double spacing) const;

 private:
  std::size_t segmentAt(double s) const;

  std::vector<Vec2> points_;
  std::vector<double> along_;
};

}  // namespace frontier_pilot::planning
