#pragma once

#include <cstddef>
#include <deque>
#include <memory>
#include <optional>
#include <vector>

#include "frontier_pilot/scan_matching/correlative_search.h"
#include "frontier_pilot/scan_matching/surface_map.h"
#include "frontier_pilot/slam/parameters.h"
#include "frontier_pilot/slam/scan_tracker.h"
#include "frontier_pilot/surfaces/surface_points.h"

namespace frontier_pilot::slam {

/// A scan that is in the local map. The local frame is continuous but drifts; it begins where odometry does.
struct Keyframe {
  std::size_t id = 0;  ///< 0, 1, 2 ...
  surfaces::SurfaceScan scan;
  surfaces::SurfacePoints points;  ///< its points, thinned for matching
  Pose2 T_local_base;
  Pose2 T_odom_base;
};

/// A part of the local map, in the base frame of its first keyframe.
struct Submap {
  std::size_t id = 0;  ///< 0, 1, 2 ...
  Pose2 T_local_submap;
  std::vector<std::size_t> keyframes;  ///< ids of the keyframes that were inserted
  double length = 0.0;                 ///< of the way through them [m]
  scan_matching::SurfaceMap map;
};

struct LocalSlamOutput {
  Track track;                                          ///< the robot's pose, and how it was found
  std::optional<Keyframe> keyframe;                     ///< if this scan became one
  std::vector<std::shared_ptr<const Submap>> finished;  ///< submaps that do not change any more, the older first
};

/// Tracks the robot by matching each scan with a submap of the last few metres. Two submaps overlap by half: scans are
/// matched with the older one and keyframes go into both, so that a submap is well filled when it becomes the older.
/// After Hess et al., ICRA 2016, IV.
class LocalSlam {
 public:
  explicit LocalSlam(const LocalSlamParameters& parameters = {}, const surfaces::SurfaceParameters& surface = {});

  /// `scan`, newer than the last one, was taken at `T_odom_base`.
  LocalSlamOutput update(const surfaces::SurfaceScan& scan, const Pose2& T_odom_base);

  /// The submaps that are being filled, the older first. They change with the next update.
  std::vector<std::shared_ptr<const Submap>> active() const { return {active_.begin(), active_.end()}; }
  /// The present pose of the odometry frame.
  const Pose2& T_local_odom() const { return tracker_.T_local_odom(); }
  /// See ScanTracker::withoutErrors.
  Pose2 withoutErrors(const Pose2& motion) const { return tracker_.withoutErrors(motion); }
  const LocalSlamParameters& parameters() const { return parameters_; }

  /// Forgets everything.
  void reset();

 private:
  bool isKeyframe(const Track& track) const;
  bool leavesSubmaps(const Pose2& T_local_base) const;
  void insert(const Keyframe& keyframe);
  void updateKnown(const surfaces::SurfacePoints& surface, const Pose2& T_local_base);
  bool isHalfFull(const Submap& submap) const;
  std::vector<std::shared_ptr<const Submap>> takeOldest(std::size_t count);
  void begin(const Pose2& T_local_submap);
  std::optional<MatchTarget> target();

  LocalSlamParameters parameters_;
  surfaces::SurfaceParameters surface_parameters_;
  ScanTracker tracker_;
  std::deque<std::shared_ptr<Submap>> active_;
  std::optional<scan_matching::MaxPyramid> pyramid_;  ///< of the older submap; none when that has changed
  std::optional<Pose2> T_local_keyframe_;             ///< pose of the last keyframe
  std::size_t keyframes_ = 0;
  std::size_t submaps_ = 0;
};

}  // namespace frontier_pilot::slam
