#pragma once

#include <optional>

#include "frontier_pilot/core/grid.h"
#include "frontier_pilot/scan_matching/correlative_search.h"
#include "frontier_pilot/scan_matching/scan_matcher.h"
#include "frontier_pilot/slam/parameters.h"
#include "frontier_pilot/slam/scan_tracker.h"
#include "frontier_pilot/surfaces/surface_points.h"

namespace frontier_pilot::localization {

/// Tracks a robot in a map that does not change. It needs an approximate initial pose: the first scan that fits within
/// three standard deviations of that determines the pose. [MAP-5]
class Localizer {
 public:
  /// `map` may be empty: then no scan ever fits. `T_map_base` is the pose where odometry has the robot at
  /// `T_odom_base`; if that is not known, at the first scan.
  Localizer(const slam::GraphSlamParameters& parameters, const OccupancyGrid& map,
            const scan_matching::PoseWithCovariance& T_map_base, const std::optional<Pose2>& T_odom_base);

  /// `scan`, newer than the last one, was taken at `T_odom_base`. Until the robot is found the verdict says
  /// why it was not.
  slam::MatchVerdict update(const surfaces::SurfaceScan& scan, const Pose2& T_odom_base);

  /// Whether the map shows anything to find the robot by.
  bool hasSurfaces() const { return pyramid_.has_value(); }
  /// Whether the robot has been found.
  bool isLocated() const { return !sought_; }
  const Pose2& T_map_odom() const { return T_map_odom_; }
  /// See ScanTracker::withoutErrors.
  Pose2 withoutErrors(const Pose2& motion) const { return tracker_.withoutErrors(motion); }

 private:
  slam::MatchVerdict find(const surfaces::SurfacePoints& points, const Pose2& T_odom_base);

  slam::LocalSlamParameters parameters_;
  surfaces::SurfaceParameters surface_parameters_;
  scan_matching::SurfaceMap map_;
  std::optional<scan_matching::MaxPyramid> pyramid_;       ///< none without a map
  std::optional<scan_matching::MaxPyramid> wide_pyramid_;  ///< for the wide search, until the robot is found
  slam::ScanTracker tracker_;
  std::optional<scan_matching::PoseWithCovariance> sought_;  ///< the given T_map_base; none once the robot is found
  std::optional<Pose2> T_odom_sought_;  ///< the T_odom_base that belongs to `sought_`; without a given one none until
                                        ///< the first scan
  Pose2 T_map_odom_;
};

}  // namespace frontier_pilot::localization
