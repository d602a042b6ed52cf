#pragma once

#include <deque>
#include <optional>
#include <vector>

#include "frontier_pilot/core/geometry.h"
#include "frontier_pilot/occupancy/occupancy_map.h"
#include "frontier_pilot/occupancy/parameters.h"
#include "frontier_pilot/surfaces/surface_points.h"

namespace frontier_pilot::occupancy {

/// The result of inserting a scan into a map.
enum class Insertion {
  kInserted,
  kAllInvalid,   ///< no beam is usable
  kOutOfBounds,  ///< the map would have to grow beyond its largest size
  kTooFar,       ///< farther from the frame's origin than a map reaches
};
/// Whether the scan was left out because the map has no room for it.
inline bool lacksRoom(Insertion insertion) {
  return insertion == Insertion::kOutOfBounds || insertion == Insertion::kTooFar;
}

/// Inserts scans into a map. A measured surface may lie on the border of a cell, and noise moves it to either side: so
/// the hit goes half a cell behind it, and the cells before it are cleared up to a margin. Both distances are measured
/// across the surface where its normal is known: half a cell along a beam that meets a wall at a flat angle is hardly
/// behind the wall, and the cells just before the surface may be the wall itself if the pose is off by a centimetre.
/// Within a scan hits take precedence over misses. A lone return, far behind both of its neighbours, marks no hit, and
/// its beam clears no farther than the nearer of them, unless another one has passed there from elsewhere before: a
/// slit is always at the same place. Even then it ends at the first obstacle on its way, as most beams meet a pane of
/// glass.
class ScanInserter {
 public:
  explicit ScanInserter(const ScanInsertionParameters& parameters = {}) : parameters_(parameters) {}

  /// `scan` was taken at `T_map_base`; both must be finite. On failure the map is untouched.
  Insertion insert(const surfaces::SurfaceScan& scan, const Pose2& T_map_base, OccupancyMap& map);
  /// Forgets where lone returns have passed. To be called when poses in the map have been corrected: otherwise a lone
  /// return would seem to pass from elsewhere when it is inserted again at its corrected pose.
  void forgetLoneReturns() { passages_.clear(); }

 private:
  struct Ray {
    Vec2 from;                ///< the sensor [m, map]
    Vec2 clear_to;            ///< cells are free from the sensor to here [m, map]
    std::optional<Vec2> hit;  ///< a point behind the surface [m, map]; lone returns and beams without one have none
  };

  /// Where a lone return passed between its neighbours.
  struct Passage {
    Vec2 at;    ///< [m, map]
    Vec2 from;  ///< the sensor [m, map]
  };

  void readRays(const surfaces::SurfaceScan& scan, const Pose2& T_map_base, double resolution);
  Ray rayThatMet(const Vec2& point, const Vec2& normal, const Vec2& sensor, double resolution) const;
  void shortenLone(const surfaces::SurfaceScan& scan);
  bool isSlit(const Passage& passage) const;
  MapRoom reserve(const Pose2& T_map_base, OccupancyMap& map) const;
  void markHits(OccupancyMap& map) const;
  void clearRays(OccupancyMap& map) const;
  void clearFootprint(const Vec2& robot, OccupancyMap& map) const;

  ScanInsertionParameters parameters_;
  std::vector<Ray> rays_;         ///< of the present scan
  std::deque<Passage> passages_;  ///< of the last lone returns
};

}  // namespace frontier_pilot::occupancy
