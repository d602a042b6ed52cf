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
  kContradicts,  ///< matched well, but elsewhere than odometry says: odometry is not believed
  kTooFew,       ///< too few returns: odometry only
  kPoor,         ///< the scan fits nowhere in the window, or after a long silence not surely: odometry only
  kAmbiguous,    ///< it fits in several places, and not where odometry says: odometry only
  kLost,         ///< nothing has matched for so long that the map is begun anew, where odometry says
};
const char* toString(MatchVerdict verdict);

/// Whether the pose is one that the map confirms.
inline bool isMatched(MatchVerdict verdict) {
  return verdict == MatchVerdict::kMatched || verdict == MatchVerdict::kContradicts;
}

/// What scans are matched with: a map, its pyramid, and where its frame lies.
struct MatchTarget {
  const scan_matching::SurfaceMap& map;
  const scan_matching::MaxPyramid& pyramid;
  Pose2 T_local_map;
};

struct Track {
  MatchVerdict verdict = MatchVerdict::kFirst;
  scan_matching::PoseWithCovariance T_local_base;  ///< the covariance is relative to what it was matched with
  double score = 0.0;                              ///< mean likelihood of the points, 0 ... 1
  double inliers = 0.0;                            ///< share of the points that lie on surfaces, 0 ... 1
  bool slides = false;  ///< matched, but along some direction the scan shows nothing, as in a bare corridor
};

/// How the pose was found, for diagnostics.
const char* describe(const Track& track);

/// Follows a robot from scan to scan: odometry says where to look and how sure it is of that, the map where the robot
/// is, and odometry again what the map does not show. Where scan and odometry contradict each other, the scan is right:
/// wheels slip and encoders freeze, walls do not. After a long silence it has to fit well for that: the scanner may
/// have been carried away. Where the scan shows nothing known, odometry carries on.
class ScanTracker {
 public:
  explicit ScanTracker(const ScanTrackerParameters& parameters = {}) : parameters_(parameters) {}

  /// `points` are those of a scan of `stamp`, taken at `T_odom_base`; without a target there is nothing yet.
  Track track(const surfaces::SurfacePoints& points, Time stamp, const Pose2& T_odom_base,
              const std::optional<MatchTarget>& target);

  /// How far a search may reach, so that pyramids fit.
  scan_matching::SearchWindow usualWindow() const;
  const Pose2& T_local_odom() const { return T_local_odom_; }
  /// Puts odometry's frame there, and forgets everything else.
  void reset(const Pose2& T_local_odom = {});

 private:
  /// Standard deviations, the same in all directions.
  struct Sigma {
    double position = 0.0;  ///< [m]
    double yaw = 0.0;       ///< [rad]
  };
  struct Prediction {
    Pose2 T_map_base;
    Sigma odometry;  ///< if odometry works as it should
    Sigma unseen;    ///< if it does not
  };
  struct Last {
    Time stamp;
    Pose2 T_odom_base;
    Time matched;  ///< when a scan was matched last
    Sigma sigma;   ///< what odometry has added since then
  };

  Sigma grown(const Sigma& sigma, const Pose2& motion) const;
  Prediction predict(Time stamp, const Pose2& T_odom_base, const Pose2& T_local_map) const;
  bool fits(const scan_matching::Refinement& refined, const surfaces::SurfacePoints& points,
            const scan_matching::SurfaceMap& map) const;
  /// Whether a match is sure enough to be right against odometry.
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
