#include "support/tour/path_shortening.h"

#include <algorithm>
#include <cmath>

namespace frontier_pilot::bench {
namespace {

constexpr double kStep = 0.4;  ///< between places from which the path sees [m]
constexpr int kMostPasses = 4;
constexpr double kLeastMove = 0.05;  ///< of a corner [m]

double lengthOf(const std::vector<Vec2>& points) {
  double sum = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i) sum += (points[i] - points[i - 1]).norm();
  return sum;
}

/// The point of the segment that is nearest to `p`.
Vec2 nearestOn(const Vec2& from, const Vec2& to, const Vec2& p) {
  const Vec2 along = to - from;
  const double square = along.squaredNorm();
  if (square == 0.0) return from;
  return from + std::clamp((p - from).dot(along) / square, 0.0, 1.0) * along;
}

}  // namespace

SeeingPath::SeeingPath(const Terrain& terrain, const Grid<std::uint8_t>& floor, const Sight& sight,
                       std::vector<Vec2> corners)
    : terrain_(terrain), seen_(floor, sight), corners_(std::move(corners)) {
  see(0, corners_.size() - 1, true);
}

double SeeingPath::length() const { return lengthOf(corners_); }

/// Places on the path from one corner to another, both included.
std::vector<Vec2> SeeingPath::places(std::size_t from, std::size_t to) const {
  std::vector<Vec2> result{corners_[from]};
  for (std::size_t i = from; i < to; ++i) {
    const Vec2 step = corners_[i + 1] - corners_[i];
    const int count = std::max(1, static_cast<int>(std::ceil(step.norm() / kStep)));
    for (int k = 1; k <= count; ++k) result.emplace_back(corners_[i] + step * k / count);
  }
  return result;
}

void SeeingPath::see(std::size_t from, std::size_t to, bool added) {
  for (const Vec2& place : places(from, to)) {
    if (added) {
      seen_.add(place);
    } else {
      seen_.remove(place);
    }
  }
}

/// Puts the points `by` (none or one) in the place of a corner, if the path stays passable and sees `share`.
bool SeeingPath::tryToReplace(std::size_t corner, const std::vector<Vec2>& by, double share) {
  const std::size_t before = corner - 1;
  const std::size_t after = std::min(corner + 1, corners_.size() - 1);
  std::vector<Vec2> points{corners_[before]};
  points.insert(points.end(), by.begin(), by.end());
  if (after > corner) points.push_back(corners_[after]);
  for (std::size_t i = 1; i < points.size(); ++i) {
    if (!terrain_.isStraight(points[i - 1], points[i])) return false;
  }
  const std::vector<Vec2> old = corners_;
  see(before, after, false);
  corners_.erase(corners_.begin() + static_cast<std::ptrdiff_t>(before),
                 corners_.begin() + static_cast<std::ptrdiff_t>(after) + 1);
  corners_.insert(corners_.begin() + static_cast<std::ptrdiff_t>(before), points.begin(), points.end());
  const std::size_t last = before + points.size() - 1;
  see(before, last, true);
  if (seen_.share() >= share && lengthOf(corners_) <= lengthOf(old) + 1e-9) return true;
  see(before, last, false);
  corners_ = old;
  see(before, after, true);
  return false;
}

bool SeeingPath::pass(double share) {
  bool changed = false;
  for (std::size_t i = corners_.size(); i-- > 1;) {
    if (tryToReplace(i, {}, share)) {
      changed = true;
      continue;
    }
    const Vec2& next = i + 1 < corners_.size() ? corners_[i + 1] : corners_[i - 1];
    const Vec2 nearest = nearestOn(corners_[i - 1], next, corners_[i]);
    for (const double part : {0.5, 0.2}) {
      const Vec2 move = part * (nearest - corners_[i]);
      if (move.norm() < kLeastMove || !tryToReplace(i, {Vec2(corners_[i] + move)}, share)) continue;
      changed = true;
      break;
    }
  }
  return changed;
}

void SeeingPath::shorten(double share) {
  for (int i = 0; i < kMostPasses && pass(share); ++i) {
  }
}

}  // namespace frontier_pilot::bench
