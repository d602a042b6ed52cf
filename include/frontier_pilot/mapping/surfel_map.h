#pragma once

#include <array>
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
  static constexpr double kCell = 0.1;  ///< [m]

  /// `points` at `T_map_points`.
  void add(const SurfacePoints& points, const Pose2& T_map_points);
  /// The nearest surfel in the cell of `point` or its neighbours that looks the same way, within 60 degrees; nullptr if
  /// there is none.
  const Surfel* nearest(const SurfacePoint& point) const;

  /// How many cells hold something, and what it all takes [bytes].
  std::size_t cellCount() const { return blocks_.size(); }
  std::size_t memory() const;

 private:
  /// One per quadrant that a normal may point into, and one for points without normal.
  using Block = std::array<Surfel, 5>;

  void add(const SurfacePoint& point);
  Block& blockAt(Cell cell);

  GrowingGrid<std::int32_t> index_{kCell, -1};
  std::vector<Block> blocks_;
};

}  // namespace frontier_pilot
