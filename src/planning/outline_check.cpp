#include "frontier_pilot/planning/outline_check.h"

#include <algorithm>
#include <cmath>

namespace frontier_pilot {
namespace {

double directionOf(const Path& path, std::size_t segment) {
  return bearing(path.points()[segment + 1] - path.points()[segment]);
}

}  // namespace

OutlineCheck::OutlineCheck(const Outline& outline) {
  if (outline.isDisc()) return;
  const std::vector<Vec2>& corners = outline.corners();
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec2 side = corners[(i + 1) % corners.size()] - corners[i];
    const int pieces = static_cast<int>(std::ceil(side.norm() / kSpacing));
    for (int k = 0; k < pieces; ++k) {
      const Vec2 point = corners[i] + side * k / pieces;
      if (point.norm() > outline.halfWidth() - 0.5 * kSpacing) points_.push_back(point);
    }
  }
  reach_ = outline.circumscribedRadius();
}

OutlineCheck OutlineCheck::inTightPlaces() const {
  OutlineCheck tight = *this;
  tight.tight_ = true;
  return tight;
}

bool OutlineCheck::fits(const ClearanceMap& map, const Pose2& T_map_base, double slack) const {
  const double lane = tight_ ? map.leastClearance() : map.requiredClearance();
  const double needed = lane - map.params().inscribed_radius + 0.5 * kSpacing - slack;
  // In the open one look-up answers for all points.
  if (isTrivial() || map.clearance(T_map_base.position()) >= reach_ + needed) return true;
  return std::all_of(points_.begin(), points_.end(),
                     [&](const Vec2& point) { return map.clearance(T_map_base * point) >= needed; });
}

bool OutlineCheck::canTurn(const ClearanceMap& map, const Vec2& position, double from, double to) const {
  if (isTrivial()) return true;
  const double angle = angleDifference(to, from);
  const int steps = std::max(1, static_cast<int>(std::ceil(std::abs(angle) * reach_ / kTurnStep)));
  for (int i = 0; i <= steps; ++i) {
    if (!fits(map, {position, from + angle * i / steps})) return false;
  }
  return true;
}

bool OutlineCheck::canDrive(const ClearanceMap& map, const Vec2& from, const Vec2& to) const {
  const double yaw = bearing(to - from);
  return fits(map, {from, yaw}) && fits(map, {to, yaw});
}

bool OutlineCheck::canFollow(const ClearanceMap& map, const Path& path, std::size_t escape, double along,
                             std::optional<double> yaw) const {
  if (isTrivial()) return true;
  for (std::size_t i = escape; i + 1 < path.points().size(); ++i) {
    if (path.arcLength(i + 1) <= along) continue;
    const double direction = directionOf(path, i);
    const bool turns = path.arcLength(i) >= along && (i > escape || (escape == 0 && yaw));
    const double before = i > escape ? directionOf(path, i - 1) : yaw.value_or(direction);
    if (turns && !canTurn(map, path.points()[i], before, direction)) return false;
    if (!fits(map, {path.points()[i + 1], direction})) return false;
  }
  return true;
}

}  // namespace frontier_pilot
