#pragma once

#include <map>

#include "frontier_pilot/core/laser_scan.h"
#include "frontier_pilot/navigation/scan_points.h"
#include "frontier_pilot/planning/clearance_map.h"

namespace frontier_pilot::navigation {

struct ObstacleLayerParams {
  double range = 3.0;          ///< how far away obstacles are taken in [m]
  double memory = 30.0;        ///< how long an obstacle out of sight is believed [s]
  int map_tolerance = 2;       ///< a hit this near to an occupied cell is the map's own [cells]
  double seen_through = 0.15;  ///< a beam this much farther than an obstacle says that it is gone [m]

  template <class Visitor>
  void describe(Visitor& v) {
    v.field("range", range, "m", "greatest range at which obstacles that the map lacks are taken in", positive());
    v.field("memory", memory, "s", "time after which an obstacle that is out of sight is forgotten", timeSpan());
    v.fixed({"map_tolerance", "seen_through"});
  }
};

/// What the live scan sees and the map does not (yet): marks it in the ClearanceMap and takes it away again when a beam
/// goes through or it is forgotten.
class ObstacleLayer {
 public:
  explicit ObstacleLayer(const ObstacleLayerParams& params = {}) : params_(params) {}

  /// Takes in a scan whose hits are `points` (map frame), from a base at `T_map_base`. Gives whether marks changed.
  bool update(const LaserScan2& scan, const ScanPoints& points, const Pose2& T_map_base, planning::ClearanceMap& map,
              Time now);
  /// Takes all marks away. Gives whether there were any.
  bool clear(planning::ClearanceMap& map);
  /// Forgets the marks of a map that is gone.
  void forget() { seen_.clear(); }
  bool empty() const { return seen_.empty(); }
  std::size_t size() const { return seen_.size(); }

 private:
  bool mark(const ScanPoints& points, const Vec2& robot, planning::ClearanceMap& map, Time now);
  bool isGone(const LaserScan2& scan, const Pose2& T_map_sensor, const Vec2& obstacle) const;

  ObstacleLayerParams params_;
  std::map<std::size_t, Time> seen_;  ///< index of the cell and when it was last hit
};

}  // namespace frontier_pilot::navigation
