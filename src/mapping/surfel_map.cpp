#include "frontier_pilot/mapping/surfel_map.h"

#include <cmath>
#include <limits>

namespace frontier_pilot {
namespace {

constexpr std::size_t kNoNormal = 4;
constexpr double kSameWay = 0.5;  ///< cosine of the greatest angle between normals that look the same way

/// Which quadrant, around an axis, a normal points into. Walls are seldom seen at 45 degrees to the submap's frame.
std::size_t quadrantOf(const Vec2& normal) {
  if (normal.x() == 0.0 && normal.y() == 0.0) return kNoNormal;
  if (std::abs(normal.x()) > std::abs(normal.y())) return normal.x() > 0.0 ? 0 : 1;
  return normal.y() > 0.0 ? 2 : 3;
}

bool looksTheSameWay(const Surfel& surfel, const SurfacePoint& point) {
  const double cosine = surfel.normal_x * point.normal.x() + surfel.normal_y * point.normal.y();
  const bool has_normal = surfel.normal_x != 0.0F || surfel.normal_y != 0.0F;
  return has_normal == point.hasNormal() && cosine >= kSameWay * std::hypot(surfel.normal_x, surfel.normal_y);
}

}  // namespace

Vec2 Surfel::normal() const {
  const double length = std::hypot(normal_x, normal_y);
  return length > 0.0 ? Vec2(normal_x / length, normal_y / length) : Vec2(0.0, 0.0);
}

void SurfelMap::add(const SurfacePoints& points, const Pose2& T_map_points) {
  const Pose2 turn(0.0, 0.0, T_map_points.yaw);
  CellRect cells;
  for (const SurfacePoint& point : points) cells.include(index_.cellAt(T_map_points * point.position));
  if (cells.empty()) return;
  index_.reserve(cells);
  for (const SurfacePoint& point : points) add({T_map_points * point.position, turn * point.normal});
}

void SurfelMap::add(const SurfacePoint& point) {
  Surfel& surfel = blockAt(index_.cellAt(point.position))[quadrantOf(point.normal)];
  surfel.count += 1.0F;
  surfel.x += (static_cast<float>(point.position.x()) - surfel.x) / surfel.count;
  surfel.y += (static_cast<float>(point.position.y()) - surfel.y) / surfel.count;
  surfel.normal_x += static_cast<float>(point.normal.x());
  surfel.normal_y += static_cast<float>(point.normal.y());
}

SurfelMap::Block& SurfelMap::blockAt(Cell cell) {
  std::int32_t& index = index_[cell];
  if (index < 0) {
    index = static_cast<std::int32_t>(blocks_.size());
    blocks_.emplace_back();
  }
  return blocks_[static_cast<std::size_t>(index)];
}

const Surfel* SurfelMap::nearest(const SurfacePoint& point) const {
  const Surfel* best = nullptr;
  double least = std::numeric_limits<double>::infinity();
  const Cell centre = index_.cellAt(point.position);
  for (int y = centre.y - 1; y <= centre.y + 1; ++y) {
    for (int x = centre.x - 1; x <= centre.x + 1; ++x) {
      const std::int32_t index = index_.get({x, y});
      if (index < 0) continue;
      for (const Surfel& surfel : blocks_[static_cast<std::size_t>(index)]) {
        const double squared = (surfel.position() - point.position).squaredNorm();
        if (surfel.count == 0.0F || squared >= least || !looksTheSameWay(surfel, point)) continue;
        least = squared;
        best = &surfel;
      }
    }
  }
  return best;
}

std::size_t SurfelMap::memory() const {
  return index_.grid().size() * sizeof(std::int32_t) + blocks_.capacity() * sizeof(Block);
}

}  // namespace frontier_pilot
