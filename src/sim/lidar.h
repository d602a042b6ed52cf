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

/// A simulated scanner: exact ranges to walls and discs, to which noise and drop-outs are added. [SIM-2]
/// The cost of the walls does not depend on the number of discs; a disc costs only the beams that point at it, and
/// hardly anything if it is behind a wall.
class Lidar {
 public:
  /// Beams that are measured one after the other while the base moves evenly.
  struct Sweep {
    std::size_t first, end;    ///< in the order in which the beams of a scan are measured
    Pose2 T_world_base;        ///< at the time of the first of them
    Vec2 step = Vec2::Zero();  ///< how far the base moves from one beam to the next [m]
    double turn = 0.0;         ///< how far it turns meanwhile [rad]
  };

  Lidar(const ScannerModel& scanner, const LidarNoise& noise);

  /// Fills `scan` as seen from a base at `T_world_base`, whose own disc `own` is not seen. By REP 117, +inf is no
  /// return and -inf is nearer than `range_min`; NaN is a drop-out.
  void scan(const Pose2& T_world_base, const grids::RayCaster& walls, const DiscIndex& discs,
            std::optional<DiscIndex::Id> own, Random& random, LaserScan2& scan);

  /// Measures the beams from `sweep.first` up to, but not including, `sweep.end` and writes them into `scan`.
  /// Discs are where they are now.
  void measure(const Sweep& sweep, const grids::RayCaster& walls, const DiscIndex& discs,
               std::optional<DiscIndex::Id> own, Random& random, LaserScan2& scan);
  /// Sets everything of `scan` but its ranges and its stamp.
  void describe(LaserScan2& scan) const;
  std::size_t beamCount() const { return beams_.size(); }

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
  void aim(const Sweep& sweep);
  void meetMoving(const Disc& disc);
  /// The beam that is the `turn`-th to be measured.
  std::size_t beamOf(std::size_t turn) const { return scanner_.reversed ? beams_.size() - 1 - turn : turn; }
  float reading(double range, Random& random) const;

  ScannerModel scanner_;
  LidarNoise noise_;
  double increment_;          ///< [rad]
  std::vector<Vec2> beams_;   ///< in the sensor's frame
  std::vector<Vec2> turned_;  ///< in the world's frame
  std::vector<double> ranges_;
  // The beams of a sweep: where each begins and whither it points in the world's frame, and its range.
  std::vector<Vec2> swept_from_, swept_;
  std::vector<double> swept_ranges_;
  std::vector<Run> runs_;
  std::array<double, kSectors> sight_{};  ///< see `measureSight` [m]
};

}  // namespace frontier_pilot::sim
