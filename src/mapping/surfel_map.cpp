#include "frontier_pilot/mapping/surfel_map.h"

#include <algorithm>
#include <cmath>

namespace frontier_pilot {
namespace {

constexpr std::int32_t kNoNormal = 4;
constexpr std::int32_t kWays = 5;
constexpr double kSameWay = 0.5;  ///< cosine of the greatest angle between normals that look the same way

/// Which quadrant, around an axis, a normal points into. Walls are seldom seen at 45 degrees to the submap's frame.
std::int32_t quadrantOf(const Vec2& normal) {
  if (normal.x() == 0.0 && normal.y() == 0.0) return kNoNormal;
  if (std::abs(normal.x()) > std::abs(normal.y())) return normal.x() > 0.0 ? 0 : 1;
  return normal.y() > 0.0 ? 2 : 3;
}

// Squares, because this is where a match spends its time.
bool looksTheSameWay(const Surfel& surfel, const SurfacePoint& point) {
  const float squared = surfel.normal_x * surfel.normal_x + surfel.normal_y * surfel.normal_y;
  const double along = surfel.normal_x * point.normal.x() + surfel.normal_y * point.normal.y();
  return (squared > 0.0F) == point.hasNormal() && along >= 0.0 && along * along >= kSameWay * kSameWay * squared;
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
    placed.push_back({T_map_points * point.position, turn * point.normal});
    needed.include(tiles_.cellAt(placed.back().position));
  }
  if (placed.empty()) return;
  tiles_.reserve(needed);
  for (const SurfacePoint& point : placed) add(point);
}

void SurfelMap::add(const SurfacePoint& point) {
  const Cell tile = tiles_.cellAt(point.position);
  const auto cell_in = [](double coordinate, int from) {
    return std::clamp(static_cast<std::int32_t>((coordinate - from * kTile) / kCell), 0, kTileCells - 1);
  };
  const std::int32_t cell = cell_in(point.position.y(), tile.y) * kTileCells + cell_in(point.position.x(), tile.x);
  Surfel& surfel = surfelAt(tile, cell * kWays + quadrantOf(point.normal));
  surfel.count += 1.0F;
  surfel.x += (static_cast<float>(point.position.x()) - surfel.x) / surfel.count;
  surfel.y += (static_cast<float>(point.position.y()) - surfel.y) / surfel.count;
  surfel.normal_x += static_cast<float>(point.normal.x());
  surfel.normal_y += static_cast<float>(point.normal.y());
}

Surfel& SurfelMap::surfelAt(Cell tile, std::int32_t place) {
  std::int32_t& first = tiles_[tile];
  for (std::int32_t i = first; i != kEnd; i = entries_[static_cast<std::size_t>(i)].next) {
    Entry& entry = entries_[static_cast<std::size_t>(i)];
    if (entry.place == place) return entry.surfel;
  }
  entries_.push_back({Surfel(), first, place});
  first = static_cast<std::int32_t>(entries_.size()) - 1;
  return entries_.back().surfel;
}

const Surfel* SurfelMap::nearest(const SurfacePoint& point) const {
  const Surfel* best = nullptr;
  double least = kReach * kReach;
  const Cell low = tiles_.cellAt(point.position - Vec2::Constant(kReach));
  const Cell high = tiles_.cellAt(point.position + Vec2::Constant(kReach));
  for (int y = low.y; y <= high.y; ++y) {
    for (int x = low.x; x <= high.x; ++x) {
      for (std::int32_t i = tiles_.get({x, y}); i != kEnd; i = entries_[static_cast<std::size_t>(i)].next) {
        const Surfel& surfel = entries_[static_cast<std::size_t>(i)].surfel;
        const double squared = (surfel.position() - point.position).squaredNorm();
        if (squared >= least || !looksTheSameWay(surfel, point)) continue;
        least = squared;
        best = &surfel;
      }
    }
  }
  return best;
}

std::size_t SurfelMap::memory() const {
  return tiles_.grid().size() * sizeof(std::int32_t) + entries_.capacity() * sizeof(Entry);
}

}  // namespace frontier_pilot
