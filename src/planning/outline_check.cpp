#include "frontier_pilot/planning/outline_check.h"

#include <algorithm>
#include <cmath>

namespace frontier_pilot::planning {
namespace {

constexpr double kSaturation = 1e-4;  // [m], by which an interpolated value may be below the largest one

double directionOf(const Path& path, std::size_t segment) {
  return bearing(path.points()[segment + 1] - path.points()[segment]);
}

bool isRingClear(const ClearanceMap& map, const Vec2& centre, double radius, double needed) {
  constexpr double kApart = 0.025;  // [m]
  const int places = static_cast<int>(std::ceil(2.0 * kPi * radius / kApart));
  for (int i = 0; i < places; ++i) {
    const double angle = 2.0 * kPi * i / places;
    if (map.clearance(centre + radius * Vec2(std::cos(angle), std::sin(angle))) < needed) return false;
  }
  return true;
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

double OutlineCheck::neededClearance(const ClearanceMap& map) const {
  const double lane = tight_ ? map.leastClearance() : map.requiredClearance();
  return lane - map.params().inscribed_radius + 0.5 * kSpacing;
}

bool OutlineCheck::fits(const ClearanceMap& map, const Pose2& T_map_base, double slack) const {
  const double needed = neededClearance(map) - slack;
  // In open space one look-up suffices for all points.
  if (isWideOpen(map, T_map_base.position())) return true;
  return std::all_of(points_.begin(), points_.end(),
                     [&](const Vec2& point) { return map.clearance(T_map_base * point) >= needed; });
}

OutlineCheck::Leave::Leave(const OutlineCheck& outline, const ClearanceMap& map, const std::optional<Pose2>& robot) {
  if (!robot) return;
  constexpr double kRounding = 0.005;  // [m]
  position_ = robot->position();
  const double needed = outline.neededClearance(map);
  for (const Vec2& point : outline.points_) {
    slack_ = std::max(slack_, needed - map.clearance(*robot * point) + kRounding);
  }
}

double OutlineCheck::Leave::slackAt(const Vec2& position) const {
  constexpr double kPlace = 0.4;  // [m]
  return (position - position_).norm() < kPlace ? slack_ : 0.0;
}

bool OutlineCheck::canTurn(const ClearanceMap& map, const Vec2& position, double from, double to, double slack) const {
  if (isTrivial()) return true;
  const double angle = angleDifference(to, from);
  const int steps = std::max(1, static_cast<int>(std::ceil(std::abs(angle) * reach_ / kTurnStep)));
  for (int i = 0; i <= steps; ++i) {
    if (!fits(map, {position, from + angle * i / steps}, slack)) return false;
  }
  return true;
}

bool OutlineCheck::isWideOpen(const ClearanceMap& map, const Vec2& position) const {
  return map.clearance(position) >= reach_ + neededClearance(map);
}

bool OutlineCheck::canTurnRound(const ClearanceMap& map, const Vec2& position) const {
  if (isTrivial() || isWideOpen(map, position)) return true;
  // Where the map tells no larger clearance, and the robot is larger, the rest of the circle is looked at.
  const double needed = neededClearance(map), known = map.farthestClearance();
  if (map.clearance(position) < known - kSaturation) return false;
  for (double radius = reach_; radius + needed > known; radius -= needed) {
    if (!isRingClear(map, position, radius, needed)) return false;
  }
  return true;
}

bool OutlineCheck::canDrive(const ClearanceMap& map, const Vec2& from, const Vec2& to) const {
  const double yaw = bearing(to - from);
  return fits(map, {from, yaw}) && fits(map, {to, yaw});
}

bool OutlineCheck::canFollow(const ClearanceMap& map, const Path& path, std::size_t escape, double along,
                             const std::optional<Pose2>& robot) const {
  if (isTrivial()) return true;
  const Leave leave(*this, map, robot);
  for (std::size_t i = escape; i + 1 < path.points().size(); ++i) {
    if (path.arcLength(i + 1) <= along) continue;
    const Vec2& here = path.points()[i];
    const Vec2& there = path.points()[i + 1];
    const double direction = directionOf(path, i);
    const bool turns = path.arcLength(i) >= along && (i > escape || (escape == 0 && robot));
    const double before = i > escape ? directionOf(path, i - 1) : (robot ? robot->yaw : direction);
    if (turns && !canTurn(map, here, before, direction, leave.slackAt(here))) return false;
    if (!fits(map, {there, direction}, leave.slackAt(there))) return false;
  }
  return true;
}

}  // namespace frontier_pilot::planning
