#include "frontier_pilot/sim/collision_map.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace frontier_pilot::sim {
namespace {

// Far enough beyond the radius that a robot in the open is cleared by one look-up even at a few metres per second.
constexpr double kLookAhead = 0.3;  // [m]

}  // namespace

CollisionMap::CollisionMap(const Grid<std::uint8_t>& solid, double radius)
    : solid_(solid),
      radius_(radius),
      needed_(radius + std::sqrt(2.0) * solid.resolution()),
      clearance_(solid_, needed_ + kLookAhead) {}

bool CollisionMap::overlaps(const Vec2& centre, double margin) const {
  const double radius = radius_ + margin;
  const GridGeometry& geometry = solid_.geometry();
  const Cell low = geometry.cellAt(centre - Vec2::Constant(radius));
  const Cell high = geometry.cellAt(centre + Vec2::Constant(radius));
  const double half = geometry.resolution / 2.0;
  for (int y = low.y; y <= high.y; ++y) {
    for (int x = low.x; x <= high.x; ++x) {
      if (solid_.get({x, y}, 1) == 0) continue;
      const Vec2 to_centre = (geometry.centre({x, y}) - centre).cwiseAbs();
      const double dx = std::max(0.0, to_centre.x() - half);
      const double dy = std::max(0.0, to_centre.y() - half);
      if (dx * dx + dy * dy < radius * radius) return true;
    }
  }
  return false;
}

std::optional<Vec2> CollisionMap::nearestFree(const Vec2& point) const {
  std::optional<Vec2> nearest;
  double best = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < solid_.size(); ++i) {
    const Vec2 centre = solid_.geometry().centre(solid_.geometry().cell(i));
    const double distance = (centre - point).squaredNorm();
    if (distance >= best || solid_[i] != 0 || overlaps(centre)) continue;
    best = distance;
    nearest = centre;
  }
  return nearest;
}

}  // namespace frontier_pilot::sim
