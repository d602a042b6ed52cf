#pragma once

#include <memory>
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
  kExtended,     ///< it shows mostly new ground: odometry's pose, corrected by what overlaps with the map
  kCarried,      ///< it shows open ground, or new ground after that: odometry's pose, good enough for the map
  kTooFew,       ///< too few returns: odometry only
  kPoor,         ///< it fits nowhere in the window, or not well enough to overrule odometry: odometry only
  kAmbiguous,    ///< it fits in several places, and not where odometry says: odometry only
  kKidnapped,    ///< nothing has matched since the wheels stood: the robot was carried, to an unknown place
  kLost,         ///< nothing has matched for so long that a new submap is begun at odometry's pose
};
const char* toString(MatchVerdict verdict);

/// Whether the pose comes from a match with the map.
inline bool isMatched(MatchVerdict verdict) {
  return verdict == MatchVerdict::kMatched || verdict == MatchVerdict::kContradicts;
}

/// Whether the pose is good enough for the scan to become part of the map.
inline bool isPlaced(MatchVerdict verdict) {
  return isMatched(verdict) || verdict == MatchVerdict::kExtended || verdict == MatchVerdict::kCarried;
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
/// odometry carries the pose on. If scans come so far apart that one may show mostly new ground, it then extends the
/// map at that pose. So do scans of open ground, where there is nothing to match with. If scans stop fitting while the
/// wheels hardly turn, the robot was carried: odometry then tells nothing until a scan fits again. Systematic errors of
/// odometry are learnt from the matches and taken into account.
class ScanTracker {
 public:
  explicit ScanTracker(const ScanTrackerParameters& parameters = {});
  ~ScanTracker();
  ScanTracker(ScanTracker&&) noexcept;
  ScanTracker& operator=(ScanTracker&&) noexcept;
  ScanTracker(const ScanTracker&) = delete;
  ScanTracker& operator=(const ScanTracker&) = delete;

  /// `points` are those of the scan at `stamp`, taken at `T_odom_base`; no target: there is no map yet. `open`: most of
  /// the scan's beams met nothing.
  Track track(const surfaces::SurfacePoints& points, Time stamp, const Pose2& T_odom_base,
              const std::optional<MatchTarget>& target, bool open = false);

  /// The window to expect normally; determines how many levels a pyramid needs.
  scan_matching::SearchWindow usualWindow() const;
  const Pose2& T_local_odom() const;
  /// A motion by odometry, in the base frame of its start, without the systematic errors learnt so far.
  Pose2 withoutErrors(const Pose2& motion) const;
  /// Sets the pose of the odometry frame, and forgets the last scan; what was learnt of odometry is kept.
  void reset(const Pose2& T_local_odom = {});

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace frontier_pilot::slam
