#include "scan_matching/surfel_map.h"

#include <cmath>

namespace frontier_pilot::scan_matching {
namespace {

constexpr double kSameWay = 0.5;  ///< cosine of the greatest angle between normals that face the same way
constexpr double kAlong = 0.5 * SurfelMap::kSpacing;  ///< a point farther along the surface is in another surfel [m]
constexpr double kAcross = 0.05;                      ///< and one farther across it is on another surface [m]

// Compares squares to avoid a root: a match spends most of its time here.
bool looksTheSameWay(const Surfel& surfel, const surfaces::SurfacePoint& point) {
  const float squared = surfel.normal_x * surfel.normal_x + surfel.normal_y * surfel.normal_y;
  const double along = surfel.normal_x * point.normal.x() + surfel.normal_y * point.normal.y();
  return (squared > 0.0F) == point.hasNormal() && along >= 0.0 && along * along >= kSameWay * kSameWay * squared;
}

/// Whether `point` belongs to the surfel. Distances are taken from the surfel rather than by fixed cells: if a border
/// between cells ran along a wall, noise would divide its points between both sides, and so make two walls.
bool belongsTo(const Surfel& surfel, const surfaces::SurfacePoint& point) {
  if (!looksTheSameWay(surfel, point)) return false;
  const Vec2 apart = point.position - surfel.position();
  if (!point.hasNormal()) return apart.squaredNorm() < kAlong * kAlong;
  const double across = apart.dot(point.normal);
  return std::abs(across) < kAcross && apart.squaredNorm() - across * across < kAlong * kAlong;
}

}  // namespace

Vec2 Surfel::normal() const {
  const double length = std::sqrt(normal_x * normal_x + normal_y * normal_y);
  return length > 0.0 ? Vec2(normal_x / length, normal_y / length) : Vec2(0.0, 0.0);
}

void Surfel::add(const surfaces::SurfacePoint& point) {
  const auto more = static_cast<float>(1.0 / point.variance());
  weight += more;
  x += (static_cast<float>(point.position.x()) - x) * more / weight;
  y += (static_cast<float>(point.position.y()) - y) * more / weight;
  normal_x += static_cast<float>(point.normal.x()) * more;
  normal_y += static_cast<float>(point.normal.y()) * more;
}

void SurfelMap::add(const surfaces::SurfacePoints& points, const Pose2& T_map_points) {
  for (const surfaces::SurfacePoint& point : surfaces::placed(T_map_points, points)) add(point);
}

void SurfelMap::updateKnown(const surfaces::SurfacePoints& points, const Pose2& T_map_points) {
  for (const surfaces::SurfacePoint& point : surfaces::placed(T_map_points, points)) {
    const std::int32_t index = surfelOf(point);
    if (index != kNone) add(point, index);
  }
}

void SurfelMap::add(const surfaces::SurfacePoint& point) {
  std::int32_t index = surfelOf(point);
  if (index != kNone) return add(point, index);
  index = static_cast<std::int32_t>(entries_.size());
  entries_.push_back({});
  entry(index).surfel.add(point);
  link(index);
}

void SurfelMap::add(const surfaces::SurfacePoint& point, std::int32_t index) {
  Surfel moved = entry(index).surfel;
  moved.add(point);
  const bool leaves = tiles_.cellAt(moved.position()) != tiles_.cellAt(entry(index).surfel.position());
  if (leaves) unlink(index);
  entry(index).surfel = moved;
  if (leaves) link(index);
}

void SurfelMap::link(std::int32_t index) {
  const Cell tile = tiles_.cellAt(entry(index).surfel.position());
  tiles_.reserve({tile.x, tile.y, 1, 1});
  std::int32_t& first = tiles_[tile];
  entry(index).next = first;
  first = index;
}

void SurfelMap::unlink(std::int32_t index) {
  std::int32_t* at = &tiles_[tiles_.cellAt(entry(index).surfel.position())];
  while (*at != index) at = &entry(*at).next;
  *at = entry(index).next;
}

std::int32_t SurfelMap::surfelOf(const surfaces::SurfacePoint& point) const {
  const double reach = std::hypot(kAlong, kAcross);
  return find(point.position, reach, [&](const Surfel& surfel) { return belongsTo(surfel, point); });
}

const Surfel* SurfelMap::nearest(const surfaces::SurfacePoint& point) const {
  const std::int32_t index =
      find(point.position, kReach, [&](const Surfel& surfel) { return looksTheSameWay(surfel, point); });
  return index == kNone ? nullptr : &entry(index).surfel;
}

std::size_t SurfelMap::memory() const {
  return tiles_.grid().size() * sizeof(std::int32_t) + entries_.capacity() * sizeof(Entry);
}

}  // namespace frontier_pilot::scan_matching
