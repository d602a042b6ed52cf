#pragma once

#include <vector>

#include "frontier_pilot/core/outline.h"
#include "sim/disc_index.h"

namespace frontier_pilot::sim {

/// Whether two discs overlap; touching is not overlapping.
inline bool overlap(const Vec2& a, double radius_a, const Disc& b) {
  const double reach = radius_a + b.radius;
  return (a - b.centre).squaredNorm() < reach * reach;
}

/// The outline of a robot at a pose, with exact tests for overlap; touching is not overlapping. Lengths in [m], in the
/// world's frame. [SIM-3]
class PlacedOutline {
 public:
  /// `outline` must outlive it.
  PlacedOutline(const Outline& outline, const Pose2& T_world_base);

  /// Where it is not placed.
  const Outline& outline() const { return outline_; }
  /// Centre and radius of the disc around the outline; the centre is the robot's base.
  Vec2 centre() const { return T_world_base_.position(); }
  double radius() const { return outline_.circumscribedRadius(); }
  /// The lower left and the upper right corner of the axis-aligned box around it.
  const Vec2& low() const { return low_; }
  const Vec2& high() const { return high_; }
  /// Whether it overlaps the axis-aligned square around `middle` with sides of 2 * `half`.
  bool overlapsSquare(const Vec2& middle, double half) const;
  bool overlapsDisc(const Disc& disc) const;
  /// Exact if both are convex or one is a disc; otherwise notches may count as parts of the outlines.
  bool overlaps(const PlacedOutline& other) const;

 private:
  const Outline& outline_;
  Pose2 T_world_base_;
  std::vector<Vec2> corners_;  ///< empty for a disc
  Vec2 low_;
  Vec2 high_;
};

}  // namespace frontier_pilot::sim
