#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "frontier_pilot/core/grid.h"
#include "frontier_pilot/core/laser_scan.h"

namespace frontier_pilot::grids {

/// Exact ranges to the solid cells of a fixed grid. A ray stops where it enters a solid cell (the surface), not at the
/// cell's centre; outside of the grid there is nothing to hit. Casting is thread-safe.
///
/// Directions are divided into 32 sectors: 8 octants with 4 classes of slopes each. For each sector and cell one byte
/// stores over how many columns (cells along the ray's longer axis) no ray of that sector, wherever it is in the cell,
/// can meet anything. A ray leaps that far at once, so walls beside it and behind it cost nothing. The index takes 32
/// bytes per cell; a ray reads only the bytes of its own sector.
class RayCaster {
 public:
  RayCaster() = default;
  /// `solid`: non-zero where a beam stops.
  explicit RayCaster(const Grid<std::uint8_t>& solid);

  /// Distance [m] from `from` (the grid's frame) along `angle` [rad] to the first solid cell; `max_range` if there is
  /// none nearer; 0 if `from` is in a solid cell. All arguments but `max_range` must be finite.
  double cast(const Vec2& from, double angle, double max_range) const {
    return cast(from, direction(angle), max_range);
  }
  /// The same along a unit vector.
  double cast(const Vec2& from, const Vec2& unit, double max_range) const;
  /// The same along many unit vectors at once, which is faster. `ranges` holds each ray's greatest range when called
  /// and its range afterwards; it must be as long as `units`.
  void castAll(const Vec2& from, const std::vector<Vec2>& units, std::vector<double>& ranges) const;
  /// The same from a point of its own for each ray.
  void castEach(const std::vector<Vec2>& from, const std::vector<Vec2>& units, std::vector<double>& ranges) const;

  const GridGeometry& geometry() const { return geometry_; }

 private:
  struct Origin;
  struct Ray;

  bool contains(const Vec2& from) const;
  Origin originAt(const Vec2& from) const;
  Ray rayAlong(const Origin& origin, const Vec2& unit, double max_cells) const;
  /// Casts the rays in turns; `origin_of` gives the origin of the ray with that index.
  template <class OriginOf>
  void castInTurns(const OriginOf& origin_of, const std::vector<Vec2>& units, std::vector<double>& ranges) const;
  double walk(const Origin& origin, const Vec2& unit, double max_range) const;
  double castFromOutside(const Vec2& from, const Vec2& unit, double max_range) const;

  GridGeometry geometry_;
  double cells_per_metre_ = 0.0;
  std::vector<std::uint8_t> leaps_;  ///< one plane per sector: 0 is solid or outside, else 1 + columns surely free
};

/// Notices a scanner that has suddenly gone blind: a scan with hardly any return, although most of its beams meet walls
/// by the map, and although a scan of less than a metre ago had returns. Then the scanner is covered or has failed, and
/// what it says of free space is not to be believed. Where returns fade out, the robot has come to open ground, also if
/// its pose is off and the map has walls there. [FLT-1]
class BlindnessCheck {
 public:
  /// `scan` was taken with the robot at `T_map_base`. `is_wall` is asked for cells of a map with this geometry, also
  /// for cells outside of it. Walls near the end of the scanner's range do not count.
  bool isBlind(const LaserScan2& scan, const Pose2& T_map_base, const GridGeometry& geometry,
               const std::function<bool(Cell)>& is_wall);

 private:
  std::optional<Vec2> saw_at_;  ///< where the last scan with returns was taken
};

}  // namespace frontier_pilot::grids
