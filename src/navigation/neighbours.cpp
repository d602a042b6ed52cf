#include "navigation/neighbours.h"

#include <algorithm>

namespace frontier_pilot::navigation {
namespace {

constexpr double kCrossingGap = 0.05;  ///< gap to where another one is going to be [m]
constexpr double kForeseen = 1.5;      ///< for how long others are taken to drive on as they do [s]

}  // namespace

bool NeighbourCheck::isFreeOf(const MovingDisc& other, const Vec2& position, double seconds) const {
  if (other.velocity.isZero()) return true;
  const double least = radius_ + other.radius + kCrossingGap;
  const Vec2 there = other.centre + seconds * other.velocity;
  return (there - position).norm() >= std::min(least, (there - here_).norm());
}

bool NeighbourCheck::isFree(const Vec2& position, double seconds) const {
  if (seconds > kForeseen) return true;
  const auto is_free = [&](const MovingDisc& other) { return isFreeOf(other, position, seconds); };
  return std::all_of(neighbours_.told.begin(), neighbours_.told.end(), is_free) &&
         std::all_of(neighbours_.seen.begin(), neighbours_.seen.end(), is_free);
}

bool NeighbourCheck::isOnOwnSide(const Vec2& position) const {
  return std::all_of(neighbours_.seen.begin(), neighbours_.seen.end(), [&](const MovingDisc& other) {
    const Vec2 to_other = other.centre - here_;
    const double distance = to_other.norm();
    if (distance < 1e-6) return true;
    const double own = std::max(0.0, 0.5 * (distance - radius_ - other.radius));
    return (position - here_).dot(to_other) <= own * distance + 1e-6;
  });
}

}  // namespace frontier_pilot::navigation
