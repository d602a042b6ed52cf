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
    : neighbours_(neighbours), here_(T_map_base.position()), radius_(outline.circumscribedRadius()) {
  for (const SeenThing& thing : neighbours.seen) {
    const Vec2 to_thing = thing.nearest - here_;
    if (to_thing.norm() < kRounding) continue;
    const double gap = to_thing.norm() - radius_ - kSideGap;
    sides_.push_back({to_thing.normalized(), std::max(0.0, 0.5 * gap)});
  }
}

bool NeighbourCheck::isFreeOf(const MovingDisc& other, const Vec2& position, double seconds) const {
  if (other.velocity.isZero()) return true;
  const double least = radius_ + other.radius + kCrossingGap;
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

bool NeighbourCheck::isOnOwnSide(const Vec2& position) const {
  return std::all_of(sides_.begin(), sides_.end(),
                     [&](const Side& side) { return side.unit.dot(position - here_) <= side.own + kRounding; });
}

}  // namespace frontier_pilot::navigation
