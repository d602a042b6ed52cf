#pragma once

#include <cstddef>
#include <deque>
#include <memory>
#include <optional>
#include <vector>

#include "frontier_pilot/core/laser_scan.h"
#include "frontier_pilot/core/parameters.h"
#include "frontier_pilot/scan_matching/surface_map.h"
#include "frontier_pilot/slam/scan_tracker.h"

namespace frontier_pilot::slam {

/// A scan that went into the local map. The local frame is smooth and drifts; it begins where odometry's does.
struct Keyframe {
  std::size_t id = 0;  ///< 0, 1, 2 ...
  LaserScan2 scan;
  surfaces::SurfacePoints points;  ///< thinned, in the base frame: what is matched
  Pose2 T_local_base;
  Pose2 T_odom_base;
};

/// A piece of the local map, in a frame of its own: that of its first keyframe's base.
struct Submap {
  std::size_t id = 0;  ///< 0, 1, 2 ...
  Pose2 T_local_submap;
  std::vector<std::size_t> keyframes;  ///< ids of those that went in
  scan_matching::SurfaceMap map;
};

struct LocalSlamParameters {
  double keyframe_distance = 0.2;  ///< a keyframe is made after moving this far [m]
  double keyframe_angle = 0.2;     ///< or turning this far [rad]
  double keyframe_inliers = 0.8;   ///< or a tenth of that where the map shows less of the scan than this share
  int submap_keyframes = 80;       ///< a submap is finished with so many; the next begins at half of them
  surfaces::SurfaceParameters surface;
  scan_matching::LikelihoodParameters likelihood;
  ScanTrackerParameters tracker;

  template <class Visitor>
  void describe(Visitor& v) {
    v.fixed({"keyframe_distance", "keyframe_angle", "keyframe_inliers", "submap_keyframes"});
    v.group("surface", surface, "how scans are read, to be matched and to be mapped");
    v.group("likelihood", likelihood, "the field that is searched");
    v.group("tracker", tracker, "how the robot is followed");
  }
};

struct LocalSlamOutput {
  Track track;                                          ///< where the robot is, and how that is known
  std::optional<Keyframe> keyframe;                     ///< if this scan became one
  std::vector<std::shared_ptr<const Submap>> finished;  ///< submaps that do not change any more, the older first
};

/// Follows the robot by matching each scan with the submap of the last few metres. Two submaps overlap by half: scans
/// are matched with the older one and keyframes go into both, so that a new one is well filled when it becomes the
/// older. After Hess et al., ICRA 2016, IV.
class LocalSlam {
 public:
  explicit LocalSlam(const LocalSlamParameters& parameters = {});

  /// `scan`, well-formed and newer than the last one, was taken at `T_odom_base`.
  LocalSlamOutput update(const LaserScan2& scan, const Pose2& T_odom_base);

  /// The submaps that are being filled, the older first. They change with the next update.
  std::vector<std::shared_ptr<const Submap>> active() const { return {active_.begin(), active_.end()}; }
  /// Where odometry's frame is by now.
  const Pose2& T_local_odom() const { return tracker_.T_local_odom(); }
  const LocalSlamParameters& parameters() const { return parameters_; }

  /// Forgets everything.
  void reset();

 private:
  bool isKeyframe(const Track& track) const;
  void insert(const Keyframe& keyframe, const surfaces::SurfacePoints& surface);
  void updateKnown(const surfaces::SurfacePoints& surface, const Pose2& T_local_base);
  std::vector<std::shared_ptr<const Submap>> takeFinished(std::size_t keyframes);
  void begin(const Pose2& T_local_submap);
  std::optional<MatchTarget> target();

  LocalSlamParameters parameters_;
  ScanTracker tracker_;
  std::deque<std::shared_ptr<Submap>> active_;
  std::optional<scan_matching::MaxPyramid> pyramid_;  ///< of the older submap; none when that has changed
  std::optional<Pose2> T_local_keyframe_;             ///< where the last keyframe is
  std::size_t keyframes_ = 0;
  std::size_t submaps_ = 0;
};

}  // namespace frontier_pilot::slam
