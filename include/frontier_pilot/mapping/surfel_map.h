#pragma once

#include <cstdint>
#include <vector>

#include "frontier_pilot/mapping/growing_grid.h"
#include "frontier_pilot/mapping/surface_points.h"

namespace frontier_pilot {

/// The mean of the points of one surface in one cell.
struct Surfel {
  float count = 0.0F;
  float x = 0.0F;  ///< mean of the positions [m]
  float y = 0.0F;
  float normal_x = 0.0F;  ///< sum of the normals
  float normal_y = 0.0F;

  Vec2 position() const { return {x, y}; }
  /// Unit; zero when the points had none.
  Vec2 normal() const;
};

/// Surfaces as means of the points that were seen of them: where a wall is, more precisely than any cell and better
/// with each scan. Surfaces of one cell that look different ways are kept apart, so both sides of a thin wall and the
/// two walls of a corner remain what they are. It grows where points are added.
class SurfelMap {
 public:
  static constexpr double kCell = 0.1;    ///< [m]
  static constexpr double kReach = 0.15;  ///< how far a surfel may be from a point that lies on it [m]

  /// `points` at `T_map_points`.
  void add(const SurfacePoints& points, const Pose2& T_map_points);
  /// The nearest surfel within `kReach` that looks the same way, within 60 degrees; nullptr if there is none.
  const Surfel* nearest(const SurfacePoint& point) const;

  std::size_t size() const { return entries_.size(); }
  /// [bytes]
  std::size_t memory() const;

 private:
  static constexpr int kTileCells = 3;
  static constexpr double kTile = kTileCells * kCell;  ///< wider than `kReach`: what is near lies in four tiles
  static constexpr std::int32_t kEnd = -1;

  /// A surfel in the list of its tile's.
  struct Entry {
    Surfel surfel;
    std::int32_t next = kEnd;
    std::int32_t place = 0;  ///< which cell of the tile, and which way it looks
  };

  void add(const SurfacePoint& point);
  Surfel& surfelAt(Cell tile, std::int32_t place);

  GrowingGrid<std::int32_t> tiles_{kTile, kEnd};  ///< the first entry of each tile
  std::vector<Entry> entries_;
};

}  // namespace frontier_pilot
