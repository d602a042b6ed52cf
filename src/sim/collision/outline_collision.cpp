#include "sim/collision/outline_collision.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace frontier_pilot::sim {
namespace {

/// Whether the segment from `a` to `b` passes through the interior of the square [-half, half]^2 [m].
/// Liang & Barsky, "A New Concept and Method for Line Clipping", ACM Transactions on Graphics 3, 1984.
bool passesThroughSquare(const Vec2& a, const Vec2& b, double half) {
  double enters = 0.0;
  double leaves = 1.0;
  for (int axis = 0; axis < 2; ++axis) {
    const double way = b[axis] - a[axis];
    if (way == 0.0) {
      if (std::abs(a[axis]) >= half) return false;
      continue;
    }
    const double one = (-half - a[axis]) / way;
    const double other = (half - a[axis]) / way;
    enters = std::max(enters, std::min(one, other));
    leaves = std::min(leaves, std::max(one, other));
  }
  return enters < leaves;
}

/// The least and the greatest coordinate of points along `axis`.
Vec2 shadow(const std::vector<Vec2>& points, const Vec2& axis) {
  Vec2 span = Vec2::Constant(axis.dot(points.front()));
  for (const Vec2& point : points) {
    span[0] = std::min(span[0], axis.dot(point));
    span[1] = std::max(span[1], axis.dot(point));
  }
  return span;
}

/// Whether a line along a side of polygon `a` has `a` and `b` on different sides; it may touch both.
bool isApart(const std::vector<Vec2>& a, const std::vector<Vec2>& b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Vec2 side = a[(i + 1) % a.size()] - a[i];
    const Vec2 axis(-side.y(), side.x());
    const Vec2 of_a = shadow(a, axis), of_b = shadow(b, axis);
    if (of_a[1] <= of_b[0] || of_b[1] <= of_a[0]) return true;
  }
  return false;
}

}  // namespace

PlacedOutline::PlacedOutline(const Outline& outline, const Pose2& T_world_base)
    : outline_(outline), T_world_base_(T_world_base) {
  if (outline.isDisc()) {
    low_ = centre() - Vec2::Constant(radius());
    high_ = centre() + Vec2::Constant(radius());
    return;
  }
  low_ = high_ = centre();
  corners_.reserve(outline.corners().size());
  for (const Vec2& corner : outline.corners()) {
    corners_.push_back(T_world_base * corner);
    low_ = low_.cwiseMin(corners_.back());
    high_ = high_.cwiseMax(corners_.back());
  }
}

bool PlacedOutline::overlapsSquare(const Vec2& middle, double half) const {
  if (outline_.isDisc()) {
    const Vec2 to_centre = (middle - centre()).cwiseAbs();
    const double dx = std::max(0.0, to_centre.x() - half);
    const double dy = std::max(0.0, to_centre.y() - half);
    return dx * dx + dy * dy < radius() * radius();
  }
  for (std::size_t i = 0; i < corners_.size(); ++i) {
    const Vec2& next = corners_[(i + 1) % corners_.size()];
    if (passesThroughSquare(corners_[i] - middle, next - middle, half)) return true;
  }
  // No side passes through the square: it lies entirely inside or entirely outside of the outline.
  return overlapsDisc({middle, 0.0});
}

bool PlacedOutline::overlapsDisc(const Disc& disc) const {
  if (outline_.isDisc()) return overlap(centre(), radius(), disc);
  return outline_.distance(T_world_base_.inverse() * disc.centre) < disc.radius;
}

bool PlacedOutline::overlaps(const PlacedOutline& other) const {
  if (other.outline_.isDisc()) return overlapsDisc({other.centre(), other.radius()});
  if (outline_.isDisc()) return other.overlapsDisc({centre(), radius()});
  return !isApart(corners_, other.corners_) && !isApart(other.corners_, corners_);
}

}  // namespace frontier_pilot::sim
