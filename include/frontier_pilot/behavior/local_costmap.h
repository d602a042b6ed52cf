#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "frontier_pilot/behavior/parameters.h"
#include "frontier_pilot/core/grid.h"
#include "frontier_pilot/core/laser_scan.h"
#include "frontier_pilot/core/outline.h"

namespace frontier_pilot::behavior {

/// What the scans say of the surroundings: a square window of the odometry frame that rolls along with the robot, each
/// cell unknown, free or occupied. What was seen stays until it is seen otherwise or leaves the window.
class LocalCostmap {
 public:
  LocalCostmap(const LocalCostmapParameters& parameters, const Outline& footprint);

  /// Takes in a scan from `T_odom_base`, the pose at its stamp. Beams clear the cells that they cross, hits occupy
  /// theirs, invalid beams say nothing; what is unknown under the robot becomes free, since it stands there.
  void insert(const LaserScan2& scan, const Pose2& T_odom_base);
  /// Forgets everything.
  void clear();

  /// -1 unknown, 0 free, 100 occupied; empty before the first scan. In the odometry frame.
  const OccupancyGrid& grid() const { return grid_; }
  /// When the last scan was measured; nothing before the first.
  std::optional<Time> stamp() const { return stamp_; }

 private:
  void roll(const Vec2& robot);
  void clearBeams(const LaserScan2& scan, const Pose2& T_odom_sensor);
  void clearUnder(const Pose2& T_odom_base);
  void setFree(const Vec2& from, const Vec2& to);

  LocalCostmapParameters parameters_;
  Outline footprint_;
  OccupancyGrid grid_;
  std::optional<Time> stamp_;
  std::vector<Cell> cells_;
};

}  // namespace frontier_pilot::behavior
