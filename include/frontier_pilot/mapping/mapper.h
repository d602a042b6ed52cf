#pragma once

#include <memory>
#include <optional>

#include "frontier_pilot/core/laser_scan.h"
#include "frontier_pilot/core/time.h"
#include "frontier_pilot/mapping/occupancy_map.h"
#include "frontier_pilot/mapping/pose_correction.h"
#include "frontier_pilot/mapping/scan_inserter.h"
#include "frontier_pilot/mapping/scan_verdict.h"

namespace frontier_pilot {

struct MapperParameters {
  double max_age = 1.0;          ///< an older scan is stale [s]
  double max_lead = 0.5;         ///< a scan may be this much ahead of the clock [s]
  double min_travel = 0.01;      ///< a robot that moved less has not moved [m]
  double min_rotation = 0.01;    ///< a robot that turned less has not turned [rad]
  double standing_period = 0.5;  ///< time between scans used while the robot stands [s]
  OccupancyMapParameters map;
  ScanInsertionParameters insertion;

  template <class Visitor>
  void describe(Visitor& v) {
    v.field("max_age", max_age, "s", "an older scan is stale", positive());
    v.field("max_lead", max_lead, "s", "a scan may be this much ahead of the clock", atLeast(0.0));
    v.field("min_travel", min_travel, "m", "a robot that moved less since the last scan stands", atLeast(0.0));
    v.field("min_rotation", min_rotation, "rad", "a robot that turned less since the last scan stands", atLeast(0.0));
    v.field("standing_period", standing_period, "s", "time between the scans used while the robot stands",
            atLeast(0.0));
    v.group("map", map, "the map and its octree");
    v.group("insertion", insertion, "how a scan goes into the map");
  }
};

/// Builds the map from scans and the odometry of the moment each was taken at. Whatever is wrong with a scan, what is
/// already mapped stays. [MAP-4]
class Mapper {
 public:
  /// Without a corrector odometry is taken for the truth.
  explicit Mapper(const MapperParameters& parameters = {}, std::unique_ptr<PoseCorrection> correction = nullptr);

  /// Puts `scan`, taken at `T_odom_base`, into the map, or says why not; no pose: there is no odometry for its stamp.
  ScanVerdict insert(const LaserScan2& scan, const std::optional<Pose2>& T_odom_base, Time now);
  /// Counts a scan that could not even be offered.
  void reject(ScanVerdict verdict) { counts_.add(verdict); }

  /// The map's projection; empty until the first scan.
  const OccupancyGrid& grid() const { return map_.grid(); }
  OccupancyMap& map() { return map_; }
  const OccupancyMap& map() const { return map_; }
  /// What changed in `grid` since the last call.
  MapChanges takeChanges() { return map_.takeChanges(); }
  const Pose2& T_map_odom() const { return T_map_odom_; }
  const ScanCounts& counts() const { return counts_; }

  /// Forgets the map and the correction; the geometry and the counts stay.
  void reset();

 private:
  struct Last {
    Time stamp;
    Pose2 T_odom_base;
  };

  ScanVerdict decide(const LaserScan2& scan, const std::optional<Pose2>& T_odom_base, Time now);
  ScanVerdict integrate(const LaserScan2& scan, const Pose2& T_odom_base);
  std::optional<ScanVerdict> checkStamp(Time stamp, Time now);
  bool hasMoved(const LaserScan2& scan, const Pose2& T_odom_base) const;

  MapperParameters parameters_;
  OccupancyMap map_;
  ScanInserter inserter_;
  std::unique_ptr<PoseCorrection> correction_;
  Pose2 T_map_odom_;
  Time now_{};
  std::optional<Last> last_;  ///< the last scan that went in
  ScanCounts counts_;
};

}  // namespace frontier_pilot
