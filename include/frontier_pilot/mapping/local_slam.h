#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "frontier_pilot/core/laser_scan.h"
#include "frontier_pilot/core/parameters.h"
#include "frontier_pilot/mapping/scan_matcher.h"
#include "frontier_pilot/mapping/surface_map.h"

namespace frontier_pilot {

/// A scan that went into the local map. The local frame is smooth and drifts; it begins where odometry's does.
struct Keyframe {
  std::size_t id = 0;  ///< 0, 1, 2 ...
  LaserScan2 scan;
  SurfacePoints points;  ///< thinned, in the base frame: what is matched
  Pose2 T_local_base;
  Pose2 T_odom_base;
};

/// A piece of the local map, in a frame of its own: that of its first keyframe's base.
struct Submap {
  std::size_t id = 0;  ///< 0, 1, 2 ...
  Pose2 T_local_submap;
  std::vector<std::size_t> keyframes;  ///< ids of those that went in
  SurfaceMap map;
};

/// What became of a scan.
enum class MatchVerdict {
  kFirst,        ///< there was nothing to match it with
  kMatched,      ///< scan and odometry agree
  kContradicts,  ///< matched well, but elsewhere than odometry says: odometry is not believed
  kTooFew,       ///< too few returns: odometry only
  kPoor,         ///< the scan fits nowhere in the window: odometry only
  kAmbiguous,    ///< it fits in several places, and not where odometry says: odometry only
};
constexpr std::size_t kMatchVerdicts = 6;
const char* toString(MatchVerdict verdict);

/// How far odometry is believed.
struct OdometryTrust {
  double distance = 0.1;      ///< standard deviation of the position per metre driven [m/m]
  double yaw_distance = 0.1;  ///< of the yaw per metre driven [rad/m]
  double yaw_turn = 0.1;      ///< of the yaw per radian turned [rad/rad]
  double unseen_speed = 0.6;  ///< the robot may move this fast unseen by odometry [m/s]
  double unseen_turn = 1.0;   ///< and turn this fast [rad/s]

  template <class Visitor>
  void describe(Visitor& v) {
    v.field("distance", distance, "m/m", "standard deviation of the position per metre driven", positive());
    v.field("yaw_distance", yaw_distance, "rad/m", "standard deviation of the yaw per metre driven", positive());
    v.field("yaw_turn", yaw_turn, "rad/rad", "standard deviation of the yaw per radian turned", positive());
    v.field("unseen_speed", unseen_speed, "m/s", "the robot may move this fast unseen by odometry", atLeast(0.0));
    v.field("unseen_turn", unseen_turn, "rad/s", "the robot may turn this fast unseen by odometry", atLeast(0.0));
  }
};

struct LocalSlamParameters {
  double keyframe_distance = 0.2;  ///< a keyframe is made after moving this far [m]
  double keyframe_angle = 0.2;     ///< or turning this far [rad]
  int submap_keyframes = 60;       ///< a submap is finished with so many; the next begins at half of them
  int min_points = 15;             ///< fewer are not matched
  double min_score = 0.45;         ///< mean likelihood that a match must reach
  double max_window = 1.0;         ///< greatest half width of the search [m]
  OdometryTrust odometry;
  SurfaceParameters surface;
  LikelihoodParameters likelihood;
  RefinementParameters refinement;

  template <class Visitor>
  void describe(Visitor& v) {
    v.field("keyframe_distance", keyframe_distance, "m", "a keyframe is made after moving this far", positive());
    v.field("keyframe_angle", keyframe_angle, "rad", "or after turning this far", positive());
    v.field("submap_keyframes", submap_keyframes, "",
            "a submap is finished with so many keyframes; the next one begins at half of them", between(2, 10000));
    v.field("min_points", min_points, "", "scans with fewer returns are not matched", between(3, 10000));
    v.field("min_score", min_score, "", "mean likelihood that a match must reach", between(0.0, 1.0));
    v.field("max_window", max_window, "m", "greatest half width of the search", positive());
    v.group("odometry", odometry, "how far odometry is believed");
    v.group("surface", surface, "how scans are read");
    v.group("likelihood", likelihood, "the field that is searched");
    v.group("refinement", refinement, "the match below the size of a cell");
  }
};

struct LocalSlamOutput {
  MatchVerdict verdict = MatchVerdict::kFirst;
  PoseBelief T_local_base;                 ///< the covariance is relative to the submap it was matched with
  double score = 0.0;                      ///< mean likelihood of the points, 0 ... 1
  std::optional<Keyframe> keyframe;        ///< if this scan became one
  std::shared_ptr<const Submap> finished;  ///< if a submap was completed: it does not change any more
};

/// Follows the robot by matching each scan with the submap of the last few metres; odometry says where to look and
/// carries what the scan does not show. Two submaps overlap by half: scans are matched with the older one and go into
/// both, so a new one is well filled when it becomes the older. After Hess et al., ICRA 2016, IV.
class LocalSlam {
 public:
  explicit LocalSlam(const LocalSlamParameters& parameters = {});

  /// `scan`, well-formed and newer than the last one, was taken at `T_odom_base`.
  LocalSlamOutput update(const LaserScan2& scan, const Pose2& T_odom_base);

  /// The submaps that are being filled, the older first. They change with the next update.
  std::vector<std::shared_ptr<const Submap>> active() const;
  /// Where odometry's frame is by now.
  const Pose2& T_local_odom() const { return T_local_odom_; }
  const LocalSlamParameters& parameters() const { return parameters_; }

  /// Forgets everything.
  void reset();

 private:
  LocalSlamParameters parameters_;
  Pose2 T_local_odom_;
};

}  // namespace frontier_pilot
