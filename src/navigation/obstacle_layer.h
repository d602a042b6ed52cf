#pragma once

#include <map>
#include <set>
#include <utility>
#include <vector>

#include "frontier_pilot/core/laser_scan.h"
#include "frontier_pilot/navigation/navigator_types.h"
#include "frontier_pilot/navigation/parameters.h"
#include "frontier_pilot/planning/clearance_map.h"
#include "navigation/scan_points.h"

namespace frontier_pilot::navigation {

/// Obstacles that the live scan shows and the map does not (yet): marks them in the ClearanceMap, and removes a mark
/// when beams pass through it or it is too old and not kept.
class ObstacleLayer {
 public:
  explicit ObstacleLayer(const ObstacleLayerParams& params = {}) : params_(params) {}

  /// Processes a scan whose hits are `points` (map frame). Returns whether marks changed.
  bool update(const ScanView& view, const ScanPoints& points, planning::ClearanceMap& map, Time now);
  /// Removes the marks that the scanner would set again if what they stand for is still there. What it does not look at
  /// it could not. Returns whether there were any.
  bool clearInView(const ScanView& view, planning::ClearanceMap& map);
  /// Removes all marks. Returns whether there were any.
  bool clear(planning::ClearanceMap& map);
  /// From now on nothing is marked inside these discs: robots that are about to leave.
  void setMakingWay(std::vector<Disc> discs) { making_way_ = std::move(discs); }
  /// Marks within `radius` [m] of one of `places` do not get too old until `releaseKept`.
  void keepNear(const std::vector<Vec2>& places, double radius, const GridGeometry& grid);
  void releaseKept() { kept_.clear(); }
  /// Forgets the marks of a map that is gone.
  void forget() {
    seen_.clear();
    kept_.clear();
  }
  bool empty() const { return seen_.empty(); }
  std::size_t size() const { return seen_.size(); }

 private:
  using Mark = std::pair<const std::size_t, Time>;  ///< index of the cell and when it was last hit

  /// Removes the marks for which `goes(mark, place)` is true, with the place [m] in the map frame. Returns whether
  /// there were any.
  template <class Goes>
  bool removeIf(planning::ClearanceMap& map, const Goes& goes);
  bool mark(const ScanPoints& points, const Vec2& robot, planning::ClearanceMap& map, Time now);
  bool isMakingWay(const Vec2& point) const;

  ObstacleLayerParams params_;
  std::vector<Disc> making_way_;
  std::set<std::size_t> kept_;        ///< indices of cells whose marks do not age
  std::map<std::size_t, Time> seen_;  ///< all marks
};

}  // namespace frontier_pilot::navigation
