#pragma once

#include <optional>
#include <vector>

#include "frontier_pilot/core/laser_scan.h"
#include "frontier_pilot/core/parameters.h"
#include "frontier_pilot/mapping/occupancy_map.h"

namespace frontier_pilot {

struct ScanInsertionParameters {
  double max_clear_range = 8.0;  ///< a beam without a return clears at most this far [m]
  double robot_radius = 0.105;   ///< where the robot stands it is free [m]
  double hit_offset = 0.5;       ///< a hit is put this much behind the measured surface [cells]
  double clear_margin = 0.3;     ///< a beam clears what it enters until this much before the surface [cells]

  template <class Visitor>
  void describe(Visitor& v) {
    v.field("max_clear_range", max_clear_range, "m", "a beam without a return clears at most this far", positive());
    v.field("robot_radius", robot_radius, "m", "a disc of this size under the robot is free", atLeast(0.0));
    v.field("hit_offset", hit_offset, "cells", "a hit is put this much behind the measured surface", between(0.0, 1.0));
    v.field("clear_margin", clear_margin, "cells", "beams clear cells until this much before the surface",
            between(0.0, 1.0));
  }
};

enum class Insertion {
  kInserted,
  kAllInvalid,   ///< no beam says anything
  kOutOfBounds,  ///< the map would have to grow beyond its largest size
};

/// Puts scans into a map. A measured surface is the border of a cell, and noise moves it to either side: so the hit
/// goes half a cell behind it, and the cells before it are cleared. Hits win over misses within a scan.
class ScanInserter {
 public:
  explicit ScanInserter(const ScanInsertionParameters& parameters = {}) : parameters_(parameters) {}

  /// `scan` was taken at `T_map_base`; both must be well-formed and finite. On failure the map is untouched.
  Insertion insert(const LaserScan2& scan, const Pose2& T_map_base, OccupancyMap& map);

 private:
  struct Ray {
    Vec2 clear_to;            ///< cells are free from the sensor to here [m, map]
    std::optional<Vec2> hit;  ///< a point in the surface [m, map]; a beam without a return has none
  };

  std::optional<Ray> ray(const LaserScan2& scan, std::size_t beam, const Pose2& T_map_sensor, double resolution) const;
  void readRays(const LaserScan2& scan, const Pose2& T_map_sensor, double resolution);
  bool reserve(const Pose2& T_map_base, const Vec2& sensor, OccupancyMap& map) const;
  void markHits(OccupancyMap& map) const;
  void clearRays(const Vec2& sensor, OccupancyMap& map) const;
  void clearFootprint(const Vec2& robot, OccupancyMap& map) const;

  ScanInsertionParameters parameters_;
  std::vector<Ray> rays_;  ///< of the present scan
};

}  // namespace frontier_pilot
