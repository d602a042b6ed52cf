#pragma once

#include <cstdint>
#include <vector>

#include "frontier_pilot/grids/growing_grid.h"
#include "frontier_pilot/surfaces/surface_points.h"

namespace frontier_pilot::scan_matching {

/// The mean of the points of one surface within `SurfelMap::kSpacing`, weighted by their inverse variances.
struct Surfel {
  float weight = 0.0F;  ///< sum of the inverse variances [1/m^2]
  float x = 0.0F;       ///< mean of the positions [m]
  float y = 0.0F;
  float normal_x = 0.0F;  ///< weighted sum of the normals
  float normal_y = 0.0F;

  Vec2 position() const { return {x, y}; }
  /// Of unit length; zero when the points had no normals.
  Vec2 normal() const;
  void add(const surfaces::SurfacePoint& point);
};

/// Surfaces as means of the points measured on them: more precise than cells, and more accurate with each scan.
/// Surfaces that face different directions are kept apart, so the two sides of a thin wall, or the walls of a corner,
/// do not merge. It grows where points are added.
class SurfelMap {
 public:
  static constexpr double kSpacing = 0.1;  ///< length of wall that a surfel stands for [m]
  static constexpr double kReach = 0.15;   ///< greatest distance from a point to the surfel it is matched with [m]

  /// Adds `points`, whose frame is at `T_map_points`.
  void add(const surfaces::SurfacePoints& points, const Pose2& T_map_points);
  /// The same, but only for points that belong to existing surfels: these become more accurate.
  void updateKnown(const surfaces::SurfacePoints& points, const Pose2& T_map_points);
  /// The nearest surfel within `kReach` that faces the same way, within 60 degrees; nullptr if there is none.
  const Surfel* nearest(const surfaces::SurfacePoint& point) const;

  std::size_t size() const { return entries_.size(); }
  /// The memory that it takes [bytes].
  std::size_t memory() const;

 private:
  static constexpr double kTile = 2.0 * kReach;  ///< so the surfels within reach of a point lie in at most four tiles
  static constexpr std::int32_t kNone = -1;

  /// A surfel, in the linked list of its tile.
  struct Entry {
    Surfel surfel;
    std::int32_t next = kNone;
  };

  Entry& entry(std::int32_t index) { return entries_[static_cast<std::size_t>(index)]; }
  const Entry& entry(std::int32_t index) const { return entries_[static_cast<std::size_t>(index)]; }
  void add(const surfaces::SurfacePoint& point);
  /// Adds `point` to a surfel, which may then lie in another tile.
  void add(const surfaces::SurfacePoint& point, std::int32_t index);
  void link(std::int32_t index);
  void unlink(std::int32_t index);

  /// The surfel nearest to `position` within `reach` [m] that `accept` accepts; kNone if there is none.
  template <class Accept>
  std::int32_t find(const Vec2& position, double reach, const Accept& accept) const {
    const Cell low = tiles_.cellAt(position - Vec2::Constant(reach));
    const Cell high = tiles_.cellAt(position + Vec2::Constant(reach));
    std::int32_t best = kNone;
    double least = reach * reach;
    for (int y = low.y; y <= high.y; ++y) {
      for (int x = low.x; x <= high.x; ++x) {
        for (std::int32_t i = tiles_.get({x, y}); i != kNone; i = entry(i).next) {
          const double squared = (entry(i).surfel.position() - position).squaredNorm();
          if (squared >= least || !accept(entry(i).surfel)) continue;
          least = squared;
          best = i;
        }
      }
    }
    return best;
  }
  /// The surfel that `point` belongs to; kNone if there is none.
  std::int32_t surfelOf(const surfaces::SurfacePoint& point) const;

  grids::GrowingGrid<std::int32_t> tiles_{kTile, kNone};  ///< the first entry of each tile
  std::vector<Entry> entries_;
};

}  // namespace frontier_pilot::scan_matching
