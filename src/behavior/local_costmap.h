#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "frontier_pilot/behavior/parameters.h"
#include "frontier_pilot/core/grid.h"
#include "frontier_pilot/core/laser_scan.h"
#include "frontier_pilot/core/outline.h"

namespace frontier_pilot::behavior {

/// A rolling costmap: a square window of the odometry frame that moves with the robot, each cell unknown, free or
/// occupied by the scans. A cell keeps its value until a scan changes it or it leaves the window.
class LocalCostmap {
 public:
  LocalCostmap(const LocalCostmapParameters& parameters, const Outline& footprint);

  /// Inserts a scan; `T_odom_base` is the pose at its stamp. Beams clear the cells that they cross, hits occupy theirs,
  /// invalid beams change nothing. Unknown cells under the robot become free, since it stands there.
  void insert(const LaserScan2& scan, const Pose2& T_odom_base);
  /// Gives the window another side [m], from the next scan on; what lies in it stays known.
  void setSide(double side) { parameters_.side = side; }
  /// Forgets everything.
  void clear();

  /// -1 unknown, 0 free, 100 occupied; empty before the first scan. In the odometry frame.
  const OccupancyGrid& grid() const { return grid_; }
  /// When the last scan was measured; nothing before the first.
  std::optional<Time> stamp() const { return stamp_; }

 private:
  void roll(const Vec2& robot);
  /// `T_odom_sensor` gives the scanner's pose at the time of a beam.
  void clearBeams(const LaserScan2& scan, const std::function<Pose2(std::size_t)>& T_odom_sensor);
  void clearUnder(const Pose2& T_odom_base);
  void setFree(const Vec2& from, const Vec2& to);

  LocalCostmapParameters parameters_;
  Outline footprint_;
  OccupancyGrid grid_;
  std::optional<Time> stamp_;
  std::vector<Cell> cells_;
};

}  // namespace frontier_pilot::behavior
