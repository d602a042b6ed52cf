#pragma once

#include <array>
#include <optional>
#include <vector>

#include "frontier_pilot/core/laser_scan.h"
#include "frontier_pilot/core/robot_model.h"
#include "frontier_pilot/grids/ray_casting.h"
#include "frontier_pilot/sim/parameters.h"
#include "sim/disc_index.h"
#include "sim/random.h"

namespace frontier_pilot::sim {

/// A scanner's optics: exact ranges to the walls and to the discs around. [SIM-2]
/// Walls cost the same however many discs there are; a disc costs the beams that point at it, and next to nothing
/// behind a wall.
class Lidar {
 public:
  Lidar(const ScannerModel& scanner, const LidarNoise& noise);

  /// Fills `scan` as seen from a base at `T_world_base`, `own` being the base itself. As REP 117 wants it: +inf is no
  /// return, -inf nearer than `range_min`, NaN a drop-out.
  void scan(const Pose2& T_world_base, const grids::RayCaster& walls, const DiscIndex& discs,
            std::optional<DiscIndex::Id> own, Random& random, LaserScan2& scan);

 private:
  static constexpr std::size_t kSectors = 64;
  /// Consecutive beams that lie in one sector.
  struct Run {
    std::size_t sector, begin, end;
  };

  void turnBeams(double yaw);
  void measureSight();
  void meetDisc(const Vec2& centre, double radius);
  void meetDisc(const Vec2& centre, double radius, double first_angle, double last_angle);
  float reading(double range, Random& random) const;

  ScannerModel scanner_;
  LidarNoise noise_;
  double increment_;          ///< [rad]
  std::vector<Vec2> beams_;   ///< in the sensor's frame
  std::vector<Vec2> turned_;  ///< in the world's frame
  std::vector<double> ranges_;
  std::vector<Run> runs_;
  std::array<double, kSectors> sight_{};  ///< [m]
};

}  // namespace frontier_pilot::sim
