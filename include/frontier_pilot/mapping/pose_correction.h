#pragma once

#include "frontier_pilot/core/geometry.h"
#include "frontier_pilot/core/laser_scan.h"
#include "frontier_pilot/mapping/occupancy_map.h"

namespace frontier_pilot {

/// The stage between odometry and the map: says where odometry's frame lies in the map when `scan` was taken.
/// A corrector that changes its mind about the past keeps its keyframes, and renders the map again from them with
/// `ScanInserter` after `OccupancyMap::clear`.
class PoseCorrection {
 public:
  virtual ~PoseCorrection() = default;
  /// `T_map_odom` for a scan taken at `T_odom_base`; `map` is what is known so far, without this scan.
  virtual Pose2 correct(const LaserScan2& scan, const Pose2& T_odom_base, const OccupancyMap& map) = 0;
  /// Forgets everything: the map has been reset.
  virtual void reset() = 0;
};

/// Takes odometry for the truth: `map` and `odom` are the same frame.
class TrustOdometry final : public PoseCorrection {
 public:
  Pose2 correct(const LaserScan2&, const Pose2&, const OccupancyMap&) override { return {}; }
  void reset() override {}
};

}  // namespace frontier_pilot
