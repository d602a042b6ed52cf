#pragma once

#include <random>
#include <vector>

#include "frontier_pilot/core/laser_scan.h"
#include "frontier_pilot/grids/distance_field.h"
#include "frontier_pilot/grids/ray_casting.h"

namespace frontier_pilot::bench {

constexpr double kRange = 8.0;  ///< of the scanner [m]

/// A floor, and a tour through it with one pose every 5 cm. No reachable place is more than 2 m away from it in x or y.
class Tour {
 public:
  Tour(const OccupancyGrid& map, const Vec2& start);

  const std::vector<Pose2>& poses() const { return poses_; }
  const grids::RayCaster& caster() const { return caster_; }

 private:
  bool isPassable(Cell c) const { return distance_.at(c) > 0.3; }
  void drive(Cell at);
  std::vector<Cell> pathToUnvisited(const Grid<std::uint8_t>& visited, Cell from) const;
  void addPose(Cell from, Cell to);

  Grid<std::uint8_t> solid_;
  grids::RayCaster caster_;
  grids::DistanceField distance_;
  std::vector<Pose2> poses_;
};

/// The tour of the Willow Garage floor, see buildings.h; nullptr if its file is absent.
const Tour* tour();

/// The tour as a robot would drive it: corners are rounded, and the robot turns before it drives on.
std::vector<Pose2> smoothed(const std::vector<Pose2>& poses);

/// A simulated scanner with 360 beams at 10 Hz and 1 cm noise.
class Scanner {
 public:
  explicit Scanner(const grids::RayCaster& caster);
  const LaserScan2& at(const Pose2& pose);

 private:
  const grids::RayCaster& caster_;
  LaserScan2 scan_;
  std::mt19937 random_{1};
  std::normal_distribution<double> noise_{0.0, 0.01};
};

}  // namespace frontier_pilot::bench
