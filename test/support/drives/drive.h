#pragma once

#include <cmath>
#include <limits>
#include <random>

#include "frontier_pilot/core/laser_scan.h"
#include "frontier_pilot/grids/ray_casting.h"

namespace frontier_pilot::test {

inline void fill(Grid<std::uint8_t>& solid, const CellRect& cells, std::uint8_t value) {
  for (int y = cells.y; y < cells.y + cells.height; ++y) {
    for (int x = cells.x; x < cells.x + cells.width; ++x) solid[Cell{x, y}] = value;
  }
}

/// Makes noisy scans of a world; the same seed gives the same scans.
class Scanner {
 public:
  Scanner(const Grid<std::uint8_t>& solid, double noise, unsigned seed = 1)
      : caster_(solid), noise_(0.0, noise > 0.0 ? noise : 1.0), noisy_(noise > 0.0), random_(seed) {}

  double range_max = 8.0;   ///< [m]
  double lost_share = 0.0;  ///< share of the beams that report that they met nothing
  std::size_t beams = 360;
  double field_of_view = 2.0 * kPi;  ///< [rad], symmetric to straight ahead
  Pose2 T_base_sensor{};

  /// The scan of a robot at `T_world_base`.
  LaserScan2 scan(const Pose2& T_world_base, Time stamp) {
    LaserScan2 scan;
    scan.stamp = stamp;
    scan.angle_min = -0.5 * field_of_view;
    scan.angle_increment = field_of_view / static_cast<double>(beams);
    scan.range_min = 0.12;
    scan.range_max = range_max;
    scan.T_base_sensor = T_base_sensor;
    const Pose2 T_world_sensor = T_world_base * T_base_sensor;
    for (std::size_t i = 0; i < beams; ++i) scan.ranges.push_back(range(T_world_sensor, scan.angle(i)));
    return scan;
  }

 private:
  float range(const Pose2& T_world_sensor, double angle) {
    constexpr float kNothing = std::numeric_limits<float>::infinity();
    const double measured = caster_.cast(T_world_sensor.position(), T_world_sensor.yaw + angle, range_max);
    const bool lost = std::uniform_real_distribution<double>()(random_) < lost_share;
    if (measured >= range_max || lost) return kNothing;
    return static_cast<float>(measured + (noisy_ ? noise_(random_) : 0.0));
  }

  grids::RayCaster caster_;
  std::normal_distribution<double> noise_;
  bool noisy_;
  std::mt19937 random_;
};

}  // namespace frontier_pilot::test
