#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "fleet/place/map_windows.h"
#include "frontier_pilot/core/geometry.h"
#include "frontier_pilot/core/grid.h"
#include "frontier_pilot/fleet/map_merger.h"

namespace frontier_pilot::fleet {

/// Whether two poses differ by less than `distance` [m] and `angle` [rad].
bool areNear(const Pose2& one, const Pose2& other, double distance, double angle);

/// Whether a search needs no more memory for this map than docs/limits.md says. The memory depends on the size of the
/// ground around the map's walls, in cells of 5 cm however large the map's own are, and on the number of points on the
/// walls. [FLT-1]
bool canBeSearched(const OccupancyGrid& map);

/// Looks for the transform between the frames of two maps that know some of the same rooms. [MUL-1]
///
/// Windows of `b`, some metres wide, are searched for all over `a`, in any direction, by branch and bound over a
/// likelihood field (Hess et al., "Real-Time Loop Closure in 2D LIDAR SLAM", ICRA 2016). What is found is refined on
/// all that both maps know, and held against it: the walls of one must lie on walls of the other where that knows the
/// place, and none in its free space. A window that fits at two places is no match. The maps have to outlive this
/// object.
class PlaceSearch {
 public:
  /// `stop` is asked again and again: once it is true, which it then has to stay, the search ends and finds nothing.
  /// Empty: it runs to its end.
  PlaceSearch(const OccupancyGrid& a, const OccupancyGrid& b, const std::function<bool()>& stop = {});
  ~PlaceSearch();
  PlaceSearch(const PlaceSearch&) = delete;
  PlaceSearch& operator=(const PlaceSearch&) = delete;

  /// The places at which the next windows of `round` fit, which is moved on.
  std::vector<PlaceMatch> search(WindowRound& round) const;
  /// The match near `T_a_b`; nothing if the maps do not agree there.
  std::optional<PlaceMatch> refine(const Pose2& T_a_b) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace frontier_pilot::fleet
