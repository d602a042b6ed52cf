#pragma once

#include <optional>

#include "frontier_pilot/core/time.h"
#include "frontier_pilot/scan_matching/correlative_search.h"
#include "frontier_pilot/scan_matching/scan_matcher.h"
#include "frontier_pilot/slam/parameters.h"

namespace frontier_pilot::slam {

/// What became of a scan.
enum class MatchVerdict {
  kFirst,        ///< there was nothing to match it with
  kMatched,      ///< scan and odometry agree
  kContradicts,  ///< matched well, but not where odometry says: the scan is believed
  kTooFew,       ///< too few returns: odometry only
  kPoor,         ///< it fits nowhere in the window, or not well enough to overrule odometry: odometry only
  kAmbiguous,    ///< it fits in several places, and not where odometry says: odometry only
  kLost,         ///< nothing has matched for so long that a new submap is begun at odometry's pose
};
const char* toString(MatchVerdict verdict);

/// Whether the pose comes from a match with the map.
inline bool isMatched(MatchVerdict verdict) {
  return verdict == MatchVerdict::kMatched || verdict == MatchVerdict::kContradicts;
}

/// What scans are matched with: a map, its pyramid, and the pose of its frame.
struct MatchTarget {
  const scan_matching::SurfaceMap& map;
  const scan_matching::MaxPyramid& pyramid;
  Pose2 T_local_map;
};

struct Track {
  MatchVerdict verdict = MatchVerdict::kFirst;
  scan_matching::PoseWithCovariance T_local_base;  ///< the covariance is relative to the map that was matched
  double score = 0.0;                              ///< mean likelihood of the points, 0 ... 1
  double inliers = 0.0;                            ///< share of the points that lie on surfaces, 0 ... 1
  bool slides = false;  ///< the scan hardly constrains the position in some direction, as in a bare corridor
};

/// How the pose was found, for diagnostics.
const char* describe(const Track& track);

/// Tracks a robot from scan to scan. Odometry predicts the pose and its uncertainty, the match with the map determines
/// the pose, and odometry decides where the scan leaves it open. Where scan and odometry contradict each other, the
/// scan is believed: wheels slip and encoders freeze, walls do not. After a long time without a match it must fit
/// very well for that, because half of the points may lie on surfaces by chance then. Where a scan fits nowhere,
/// odometry carries the pose on.
class ScanTracker {
 public:
  explicit ScanTracker(const ScanTrackerParameters& parameters = {}) : parameters_(parameters) {}

  /// `points` are those of the scan at `stamp`, taken at `T_odom_base`; no target: there is no map yet.
  Track track(const surfaces::SurfacePoints& points, Time stamp, const Pose2& T_odom_base,
              const std::optional<MatchTarget>& target);

  /// The window to expect normally; determines how many levels a pyramid needs.
  scan_matching::SearchWindow usualWindow() const;
  const Pose2& T_local_odom() const { return T_local_odom_; }
  /// Sets the pose of the odometry frame, and forgets everything else.
  void reset(const Pose2& T_local_odom = {});

 private:
  /// Standard deviations, the same in all directions.
  struct Sigma {
    double position = 0.0;  ///< [m]
    double yaw = 0.0;       ///< [rad]
  };
  struct Prediction {
    Pose2 T_map_base;
    Sigma odometry;  ///< if odometry works correctly
    Sigma unseen;    ///< if it may have missed motion, such as slip
  };
  struct Last {
    Time stamp;
    Pose2 T_odom_base;
    Time matched;  ///< when a scan was matched last
    Sigma sigma;   ///< the uncertainty that odometry has added since then
  };

  Sigma grown(const Sigma& sigma, const Pose2& motion) const;
  Prediction predict(Time stamp, const Pose2& T_odom_base, const Pose2& T_local_map) const;
  bool fits(const scan_matching::Refinement& refined, const surfaces::SurfacePoints& points,
            const scan_matching::SurfaceMap& map) const;
  /// Whether a match is reliable enough to be believed although it contradicts odometry.
  bool overrulesOdometry(const scan_matching::Refinement& refined, const surfaces::SurfacePoints& points,
                         const MatchTarget& target, const Prediction& prediction) const;
  Track match(const surfaces::SurfacePoints& points, const MatchTarget& target, const Prediction& prediction) const;
  std::optional<scan_matching::SearchResult> find(const surfaces::SurfacePoints& points,
                                                  const scan_matching::MaxPyramid& pyramid,
                                                  const Prediction& prediction) const;
  bool hasRival(const surfaces::SurfacePoints& points, const scan_matching::MaxPyramid& pyramid,
                const Prediction& prediction, const scan_matching::SearchResult& found) const;
  scan_matching::SearchRequest request(const Prediction& prediction, double resolution) const;
  void remember(Time stamp, const Pose2& T_odom_base, const Track& track);

  ScanTrackerParameters parameters_;
  Pose2 T_local_odom_;
  std::optional<Last> last_;
};

}  // namespace frontier_pilot::slam
