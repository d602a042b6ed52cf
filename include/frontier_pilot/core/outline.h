#pragma once

#include <vector>

#include "frontier_pilot/core/geometry.h"
#include "frontier_pilot/core/grid.h"

namespace frontier_pilot {

/// The corners in a flat list x1, y1, x2, y2, ...; a number left over at its end is ignored.
std::vector<Vec2> cornersOf(const std::vector<double>& numbers);
/// Why these corners make no simple polygon: at least three and at most 1000 of them, sides that do not cross, an area.
/// Empty if they do.
const char* polygonProblem(const std::vector<Vec2>& corners);
/// Area of a simple polygon [m^2], its corners in either sense of rotation.
double polygonArea(const std::vector<Vec2>& corners);
/// Whether `point` lies inside a simple polygon.
bool polygonContains(const std::vector<Vec2>& corners, const Vec2& point);

/// The outline (footprint) of a robot in its base frame: a disc around the frame's origin, or a simple polygon that
/// contains it. The origin lies between the wheels; the robot turns in place about it. Lengths in [m].
class Outline {
 public:
  /// A disc around the base's origin; `radius` > 0.
  static Outline disc(double radius);
  /// A polygon, its corners in either sense of rotation: at least three of them, with an area, and with the base's
  /// origin inside. Throws std::invalid_argument otherwise.
  static Outline polygon(std::vector<Vec2> corners);
  /// Why these corners are refused by `polygon`; empty if they are not.
  static const char* problem(const std::vector<Vec2>& corners);

  bool isDisc() const { return is_disc_; }
  /// The polygon's corners, counter-clockwise; for a disc, those of a 32-sided polygon around it.
  const std::vector<Vec2>& corners() const { return corners_; }
  /// Radius of the largest disc around the base's origin that fits inside.
  double inscribedRadius() const { return inscribed_; }
  /// Radius of the smallest disc around the base's origin that contains the outline: what a full turn in place sweeps.
  double circumscribedRadius() const { return circumscribed_; }
  /// How far it reaches to the side, left or right: half the width of the lane that the robot sweeps driving straight.
  double halfWidth() const { return half_width_; }
  /// How far it reaches ahead of the base's origin, and behind it.
  double front() const { return front_; }
  double rear() const { return rear_; }

  /// The same outline with every side moved outward by `margin`. No corner moves farther than twice the margin.
  Outline padded(double margin) const;
  /// Distance from the outline to `point`, in the base frame; negative inside.
  double distance(const Vec2& point) const;
  /// Distance from `from` along the unit vector `unit` to where the ray leaves the outline; 0 if `from` is outside.
  double distanceToEdge(const Vec2& from, const Vec2& unit) const;
  /// The place on its edge that is nearest to `point`, which is not its origin, in the base frame.
  Vec2 nearestTo(const Vec2& point) const;
  /// How far it reaches from the base's origin along the unit vector `unit`, in the base frame.
  double reach(const Vec2& unit) const;
  /// Every cell of `geometry` that the outline of a robot at `T_grid_base` touches or contains, even outside of the
  /// grid. In no particular order, and some cells repeat. Overwrites `cells`, so that the caller can reuse its memory.
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
