#include "frontier_pilot/mapping/surfel_map.h"

#include <algorithm>
#include <cmath>

namespace frontier_pilot {
namespace {

constexpr double kSameWay = 0.5;  ///< cosine of the greatest angle between normals that look the same way

// Squares, because this is where a match spends its time.
bool looksTheSameWay(const Surfel& surfel, const SurfacePoint& point) {
  const float squared = surfel.normal_x * surfel.normal_x + surfel.normal_y * surfel.normal_y;
  const double along = surfel.normal_x * point.normal.x() + surfel.normal_y * point.normal.y();
  return (squared > 0.0F) == point.hasNormal() && along >= 0.0 && along * along >= kSameWay * kSameWay * squared;
}

/// Whether `point` is one more of the points that the surfel is the mean of. Across the surface it may be off by its
/// noise, and that must not decide: points on either side of a border that ran along the wall would be two walls.
bool belongsTo(const Surfel& surfel, const SurfacePoint& point) {
  constexpr double kAcross = 0.05;  // [m]
  if (!looksTheSameWay(surfel, point)) return false;
  const Vec2 apart = point.position - surfel.position();
  const double along = 0.5 * SurfelMap::kSpacing;
  if (!point.hasNormal()) return apart.squaredNorm() < along * along;
  const double across = apart.dot(point.normal);
  return std::abs(across) < kAcross && apart.squaredNorm() - across * across < along * along;
}

}  // namespace

Vec2 Surfel::normal() const {
  const double length = std::sqrt(normal_x * normal_x + normal_y * normal_y);
  return length > 0.0 ? Vec2(normal_x / length, normal_y / length) : Vec2(0.0, 0.0);
}

void SurfelMap::add(const SurfacePoints& points, const Pose2& T_map_points) {
  const Pose2 turn(0.0, 0.0, T_map_points.yaw);
  SurfacePoints placed;
  placed.reserve(points.size());
  CellRect needed;
  for (const SurfacePoint& point : points) {
    placed.push_back(point);
    placed.back().position = T_map_points * point.position;
    placed.back().normal = turn * point.normal;
    needed.include(tiles_.cellAt(placed.back().position));
  }
  if (placed.empty()) return;
  tiles_.reserve(needed);
  for (const SurfacePoint& point : placed) add(point);
}

void SurfelMap::add(const SurfacePoint& point) {
  const auto weight = static_cast<float>(1.0 / point.variance());
  Surfel& surfel = surfelFor(point);
  surfel.weight += weight;
  const float share = weight / surfel.weight;
  surfel.x += (static_cast<float>(point.position.x()) - surfel.x) * share;
  surfel.y += (static_cast<float>(point.position.y()) - surfel.y) * share;
  surfel.normal_x += static_cast<float>(point.normal.x()) * weight;
  surfel.normal_y += static_cast<float>(point.normal.y()) * weight;
}

Surfel& SurfelMap::surfelFor(const SurfacePoint& point) {
  Surfel* best = nullptr;
  double least = kReach * kReach;
  visitNear(point.position, kMerge, [&](const Surfel& surfel) {
    const double squared = (surfel.position() - point.position).squaredNorm();
    if (squared >= least || !belongsTo(surfel, point)) return;
    least = squared;
    best = const_cast<Surfel*>(&surfel);
  });
  if (best) return *best;
  std::int32_t& first = tiles_[tiles_.cellAt(point.position)];
  entries_.push_back({Surfel(), first});
  first = static_cast<std::int32_t>(entries_.size()) - 1;
  return entries_.back().surfel;
}

const Surfel* SurfelMap::nearest(const SurfacePoint& point) const {
  const Surfel* best = nullptr;
  double least = kReach * kReach;
  visitNear(point.position, kReach, [&](const Surfel& surfel) {
    const double squared = (surfel.position() - point.position).squaredNorm();
    if (squared >= least || !looksTheSameWay(surfel, point)) return;
    least = squared;
    best = &surfel;
  });
  return best;
}

std::size_t SurfelMap::memory() const {
  return tiles_.grid().size() * sizeof(std::int32_t) + entries_.capacity() * sizeof(Entry);
}

}  // namespace frontier_pilot
