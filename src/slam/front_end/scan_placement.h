#pragma once

#include "frontier_pilot/scan_matching/correlative_search.h"
#include "frontier_pilot/scan_matching/scan_matcher.h"
#include "frontier_pilot/slam/parameters.h"
#include "frontier_pilot/slam/scan_tracker.h"
#include "slam/front_end/odometry_model.h"

namespace frontier_pilot::slam {

/// Where odometry expects the robot.
struct Prediction {
  Pose2 T_map_base;
  PoseSigma odometry;    ///< if odometry works correctly
  PoseSigma unseen;      ///< if it may have missed motion, such as slip
  bool sparse = false;   ///< the robot has moved far since the last scan, so that the two may overlap little
  bool open = false;     ///< most beams of the scan met nothing
  bool carried = false;  ///< since the last match there was little to match
};

scan_matching::PoseWithCovariance beliefOf(const Pose2& pose, const PoseSigma& sigma);

/// Places one scan on a map. A scan is matched in all of the window that odometry's errors leave. Of two sparse scans
/// the second may show mostly new ground: then no match can be told from chance, but odometry's pose is good enough to
/// extend the map, and what overlaps corrects it within odometry's uncertainty.
class ScanPlacement {
 public:
  explicit ScanPlacement(const ScanTrackerParameters& parameters = {}) : parameters_(parameters) {}

  Track place(const surfaces::SurfacePoints& points, const MatchTarget& target, const Prediction& prediction) const;

 private:
  Track match(const surfaces::SurfacePoints& points, const MatchTarget& target, const Prediction& prediction) const;
  Track extend(const surfaces::SurfacePoints& points, const MatchTarget& target, const Prediction& prediction) const;
  /// Whether a match that contradicts odometry is to be preferred to extending the map near odometry's pose.
  bool isPreferred(const Track& match, const Track& extension, const MatchTarget& target,
                   const Prediction& prediction) const;
  bool fits(const scan_matching::Refinement& refined, const surfaces::SurfacePoints& points,
            const scan_matching::SurfaceMap& map) const;
  /// Whether a match is reliable enough to be believed although it contradicts odometry.
  bool overrulesOdometry(const scan_matching::Refinement& refined, const surfaces::SurfacePoints& points,
                         const MatchTarget& target, const Prediction& prediction) const;
  /// Whether a scan that was not matched shows open ground, or what comes into sight beyond it.
  bool isBeyondTheMap(const surfaces::SurfacePoints& points, const MatchTarget& target, const Prediction& prediction,
                      const Track& match) const;
  bool hasRival(const surfaces::SurfacePoints& points, const scan_matching::MaxPyramid& pyramid,
                const Prediction& prediction, const scan_matching::SearchResult& found) const;
  scan_matching::SearchRequest request(const Prediction& prediction, double resolution) const;
  scan_matching::SearchRequest nearRequest(const Prediction& prediction, double resolution) const;

  ScanTrackerParameters parameters_;
};

}  // namespace frontier_pilot::slam
