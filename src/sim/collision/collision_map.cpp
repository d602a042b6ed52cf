#include "sim/collision/collision_map.h"

#include <cmath>
#include <limits>

namespace frontier_pilot::sim {
namespace {

// How far beyond the radius distances are known: enough that for a robot in the open, even at a few metres per second,
// one look-up shows that a step is free.
constexpr double kLookAhead = 0.3;  // [m]

}  // namespace

CollisionMap::CollisionMap(const Grid<std::uint8_t>& solid, double greatest_radius)
    : solid_(solid),
      diagonal_(std::sqrt(2.0) * solid.resolution()),
      clearance_(solid_, greatest_radius + diagonal_ + kLookAhead) {}

bool CollisionMap::overlaps(const PlacedOutline& placed) const {
  const GridGeometry& geometry = solid_.geometry();
  const Cell low = geometry.cellAt(placed.low());
  const Cell high = geometry.cellAt(placed.high());
  const double half = geometry.resolution / 2.0;
  for (int y = low.y; y <= high.y; ++y) {
    for (int x = low.x; x <= high.x; ++x) {
      if (solid_.get({x, y}, 1) != 0 && placed.overlapsSquare(geometry.centre({x, y}), half)) return true;
    }
  }
  return false;
}

std::optional<Vec2> CollisionMap::nearestFree(const Outline& outline, const Pose2& pose) const {
  std::optional<Vec2> nearest;
  double best = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < solid_.size(); ++i) {
    const Vec2 centre = solid_.geometry().centre(solid_.geometry().cell(i));
    const double distance = (centre - pose.position()).squaredNorm();
    if (distance >= best || solid_[i] != 0 || overlaps({outline, {centre, pose.yaw}})) continue;
    best = distance;
    nearest = centre;
  }
  return nearest;
}

}  // namespace frontier_pilot::sim
