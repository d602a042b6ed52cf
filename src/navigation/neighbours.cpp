#include "navigation/neighbours.h"

#include <algorithm>

namespace frontier_pilot::navigation {
namespace {

constexpr double kCrossingGap = 0.05;  ///< gap to where another one is going to be [m]
constexpr double kForeseen = 1.5;      ///< for how long others are taken to drive on as they do [s]
constexpr double kSideGap = 0.03;   ///< that is left between both sides, as places are some tenths of a second old [m]
constexpr double kRounding = 1e-6;  ///< of a place compared with the one where the robot is [m]

}  // namespace

NeighbourCheck::NeighbourCheck(const Neighbours& neighbours, const Pose2& T_map_base, const Outline& outline)
    : neighbours_(neighbours), outline_(outline), here_(T_map_base.position()) {
  for (const SeenThing& thing : neighbours.seen) {
    const Vec2 in_base = T_map_base.inverse() * thing.nearest;
    if (in_base.norm() < kRounding) continue;
    const auto own = [](double gap) { return std::max(0.0, 0.5 * (gap - kSideGap)); };
    const Vec2 ahead = (thing.nearest - here_).normalized();
    const double gap = outline.distance(in_base);
    const Vec2 apart = thing.nearest - T_map_base * outline.nearestTo(in_base);
    const Vec2 across = gap > kRounding ? Vec2(apart.normalized()) : ahead;
    borders_.push_back({ahead, ahead.dot(here_) + own(in_base.norm() - outline.circumscribedRadius()), across,
                        reachAlong(across, T_map_base) + own(gap)});
  }
}

/// The coordinate along `unit`, in the map frame, of the part of the outline that is farthest there.
double NeighbourCheck::reachAlong(const Vec2& unit, const Pose2& pose) const {
  return unit.dot(pose.position()) + outline_.reach(Rotation2(-pose.yaw) * unit);
}

bool NeighbourCheck::isFreeOf(const MovingDisc& other, const Vec2& position, double seconds) const {
  if (other.velocity.isZero()) return true;
  const double least = outline_.circumscribedRadius() + other.radius + kCrossingGap;
  const Vec2 there = other.centre + seconds * other.velocity;
  return (there - position).norm() >= std::min(least, (there - here_).norm());
}

bool NeighbourCheck::isFree(const Vec2& position, double seconds) const {
  if (seconds > kForeseen) return true;
  return std::all_of(neighbours_.told.begin(), neighbours_.told.end(),
                     [&](const MovingDisc& other) { return isFreeOf(other, position, seconds); }) &&
         std::all_of(neighbours_.seen.begin(), neighbours_.seen.end(),
                     [&](const SeenThing& thing) { return isFreeOf(thing.body, position, seconds); });
}

/// Whether the outline at `pose` is on this side of a border.
bool NeighbourCheck::keeps(const Border& border, const Pose2& pose) const {
  return reachAlong(border.across, pose) <= border.widest + kRounding;
}

bool NeighbourCheck::isOnOwnSide(const Pose2& pose) const {
  return std::all_of(borders_.begin(), borders_.end(), [&](const Border& border) {
    return border.ahead.dot(pose.position()) <= border.farthest + kRounding &&
           (outline_.isDisc() || keeps(border, pose));
  });
}

bool NeighbourCheck::isOutlineOnOwnSide(const Pose2& pose) const {
  return std::all_of(borders_.begin(), borders_.end(), [&](const Border& border) { return keeps(border, pose); });
}

}  // namespace frontier_pilot::navigation
