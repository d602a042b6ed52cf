#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "frontier_pilot/core/geometry.h"
#include "frontier_pilot/core/grid.h"
#include "frontier_pilot/occupancy/parameters.h"
#include "frontier_pilot/scan_matching/scan_matcher.h"
#include "frontier_pilot/slam/parameters.h"
#include "frontier_pilot/slam/pose_correction.h"
#include "frontier_pilot/surfaces/surface_points.h"

namespace frontier_pilot::localization {

/// The returns of a scan in its base frame, and the pose of that base in the frame of the last of several scans.
struct RecentScan {
  surfaces::SurfacePoints points;
  Pose2 T_last_base;
};

/// A pose in the known map at which scans fit.
struct Place {
  Pose2 T_map_base;
  double inliers = 0.0;  ///< share of the beams that end on surfaces of the map, 0 ... 1
};

enum class SearchVerdict {
  kFound,        ///< the scans fit at `best`, and nowhere else nearly as well
  kNoMap,        ///< the map has no surface
  kTooLarge,     ///< the map would take too much memory to be searched
  kTooFew,       ///< there is no scan, or too few returns
  kFitsNowhere,  ///< the scans fit nowhere on the map
  kAmbiguous,    ///< they fit at `best` and at `rival` nearly alike
  kStopped,      ///< the search was stopped before its end
};

/// The result of a search of the whole map.
struct WholeMapSearch {
  SearchVerdict verdict = SearchVerdict::kNoMap;
  Place best;   ///< if the verdict is kFound or kAmbiguous; its pose is that of the last scan
  Place rival;  ///< if the verdict is kAmbiguous
};

/// Looks for the robot all over `map`, in any direction, by its last scans, the latest at the end; if they do not fit
/// together, by the latest alone, which has to fit in any case. A place is refused rather than guessed: it must be
/// free, the beams may not pass through walls, and a second such place, more than 0.5 m or 0.3 rad away, must reach
/// less than 90 % of the best one's score or share of beams that end on surfaces. Branch and bound as in
/// correlativeSearch. On a floor of 58 m x 47 m it takes about a second; in the worst case the time grows with the
/// number of poses. Once `stop` is true, which it then has to stay, the search ends. [MAP-5]
WholeMapSearch searchWholeMap(const OccupancyGrid& map, const std::vector<RecentScan>& scans,
                              const slam::GraphSlamParameters& parameters, const std::function<bool()>& stop = {});

/// The result in words, for the operator.
std::string describe(const WholeMapSearch& search);

/// Localisation in a known map: finds the robot in it, and then either tracks it there and leaves the map as it is, or
/// continues mapping. In that case new scans are matched only with each other, and inserted into the known map. Until
/// the robot is found no scan is inserted. On a map without walls it cannot be found: mapping continues from where it
/// is said to be. [MAP-5]
class MapLocalization final : public slam::PoseCorrection {
 public:
  enum class Use {
    kLocalizeOnly,   ///< the map stays as it is
    kGoOnMapping,    ///< mapping continues with scan matching and loop closing
    kTrustOdometry,  ///< odometry is taken for the truth from the pose at which the robot was found
  };

  /// `map` is the known map; revised maps get its parameters. `T_map_base` is a rough estimate of the robot's pose
  /// where odometry has it at `T_odom_base`; if that is not known, at the first scan.
  MapLocalization(Use use, const slam::GraphSlamParameters& parameters, occupancy::OccupancyMap& map,
                  const occupancy::ScanInsertionParameters& insertion,
                  const scan_matching::PoseWithCovariance& T_map_base,
                  const std::optional<Pose2>& T_odom_base = std::nullopt);
  ~MapLocalization() override;
  MapLocalization(const MapLocalization&) = delete;
  MapLocalization& operator=(const MapLocalization&) = delete;

  slam::CorrectedScan correct(const surfaces::SurfaceScan& scan, const Pose2& T_odom_base,
                              const occupancy::OccupancyMap& map) override;
  Pose2 withoutErrors(const Pose2& motion) const override;
  slam::RevisionWork takeWork() override;
  bool accept(const slam::MapRevision& revision) override;
  bool refuse(const slam::MapRevision& revision) override;
  void abandonWork() override;
  std::vector<slam::KeyframePose> trajectory() const override;
  std::size_t keyframes() const override;
  void reset() override;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Takes odometry for the truth: `map` and `odom` are the same frame. There is one exception: if a scan agrees with the
/// map, and the next one shows another place although the robot has hardly moved, it was carried (the kidnapped robot
/// problem). From then on `fits_map` and `located` are false, so that nothing is inserted, until a scan agrees with the
/// map at odometry's pose again. [MAP-5]
class TrustedOdometry final : public slam::PoseCorrection {
 public:
  slam::CorrectedScan correct(const surfaces::SurfaceScan& scan, const Pose2& T_odom_base,
                              const occupancy::OccupancyMap& map) override;
  void reset() override;

 private:
  std::optional<Pose2> agreed_at_;  ///< T_odom_base of the last scan; none if it did not agree with the map
  bool kidnapped_ = false;
};

}  // namespace frontier_pilot::localization
