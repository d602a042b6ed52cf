#pragma once

#include <vector>

#include "frontier_pilot/core/geometry.h"
#include "frontier_pilot/core/grid.h"

namespace frontier_pilot {

/// The outline of a robot in its base frame, whose origin lies between the wheels, about which it turns: a disc around
/// that origin, or a simple polygon that holds it. Lengths in [m].
class Outline {
 public:
  /// A disc around the base's origin; `radius` > 0.
  static Outline disc(double radius);
  /// A polygon, in either sense of rotation: at least three corners, an area, and the base's origin inside. Throws
  /// std::invalid_argument with what is wrong.
  static Outline polygon(std::vector<Vec2> corners);
  /// What is wrong with such a polygon; empty: nothing.
  static const char* problem(const std::vector<Vec2>& corners);

  bool isDisc() const { return is_disc_; }
  /// Of the polygon, counter-clockwise; of a polygon around the disc, hardly larger than it.
  const std::vector<Vec2>& corners() const { return corners_; }
  /// The largest disc around the base's origin that lies inside.
  double inscribedRadius() const { return inscribed_; }
  /// The smallest disc around the base's origin that holds it: what a robot needs that turns right round.
  double circumscribedRadius() const { return circumscribed_; }
  /// How far it reaches to the side: half the width of the lane of a robot that drives straight on.
  double halfWidth() const { return half_width_; }
  /// How far it reaches ahead of the base's origin, and behind it.
  double front() const { return front_; }
  double rear() const { return rear_; }

  /// The same outline with every side moved outward by `margin`. Mitred corners are cut at twice the margin.
  Outline padded(double margin) const;
  /// From the outline to `point`, both in the base frame; negative inside.
  double distance(const Vec2& point) const;
  /// Where the ray from `from`, a point inside, in the direction `unit` leaves it; 0 if `from` lies outside.
  double distanceToEdge(const Vec2& from, const Vec2& unit) const;
  /// Every cell of `geometry`'s raster that the outline of a robot at `T_grid_base` touches or holds, inside the grid
  /// or not, in no order; a cell may come twice. `cells` is overwritten, so that a caller can keep its memory.
  void cellsAt(const Pose2& T_grid_base, const GridGeometry& geometry, std::vector<Cell>& cells) const;

 private:
  Outline(std::vector<Vec2> corners, bool is_disc, double radius);

  std::vector<Vec2> corners_;
  bool is_disc_;
  double inscribed_;
  double circumscribed_;
  double half_width_ = 0.0;
  double front_ = 0.0;
  double rear_ = 0.0;
};

}  // namespace frontier_pilot
