#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <vector>

#include "frontier_pilot/core/geometry.h"
#include "frontier_pilot/mapping/mapper.h"
#include "frontier_pilot/surfaces/surface_points.h"

namespace frontier_pilot::mapping {

/// The scans of the last metres, for a search of the whole map: several show more of what tells one place from another
/// than a single one.
class RecentScans {
 public:
  /// `points` of a scan taken at `T_odom_base`.
  void add(const surfaces::SurfacePoints& points, const Pose2& T_odom_base);
  void clear();

  /// The scans, the latest at the end; none before the first.
  std::vector<localization::RecentScan> scans() const;
  /// The search of `map`, the mapper's `generation`-th, for the robot by copies of these scans, until `stop` is true.
  std::function<RobotSearch()> searchOn(const OccupancyGrid& map, std::uint64_t generation,
                                        const slam::GraphSlamParameters& parameters,
                                        const std::function<bool()>& stop) const;

 private:
  struct Entry {
    surfaces::SurfacePoints points;
    Pose2 T_odom_base;
  };
  std::deque<Entry> kept_;  ///< without the latest
  Entry latest_;
  bool has_latest_ = false;
};

}  // namespace frontier_pilot::mapping
