#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "frontier_pilot/occupancy/parameters.h"
#include "frontier_pilot/scan_matching/scan_matcher.h"
#include "frontier_pilot/slam/parameters.h"
#include "frontier_pilot/slam/pose_correction.h"

namespace frontier_pilot::localization {

/// Localisation in a known map: finds the robot in it, and then either tracks it there and leaves the map as it is, or
/// continues mapping. In that case new scans are matched only with each other, and inserted into the known map. Until
/// the robot is found no scan is inserted.
/// [MAP-5]
class MapLocalization final : public slam::PoseCorrection {
 public:
  enum class Use {
    kLocalizeOnly,   ///< the map stays as it is
    kGoOnMapping,    ///< mapping continues with scan matching and loop closing
    kTrustOdometry,  ///< odometry is taken for the truth from the pose at which the robot was found
  };

  /// `map` is the known map; revised maps get its parameters. `T_map_base` is a rough estimate of the robot's pose.
  MapLocalization(Use use, const slam::GraphSlamParameters& parameters, occupancy::OccupancyMap& map,
                  const occupancy::ScanInsertionParameters& insertion,
                  const scan_matching::PoseWithCovariance& T_map_base);
  ~MapLocalization() override;
  MapLocalization(const MapLocalization&) = delete;
  MapLocalization& operator=(const MapLocalization&) = delete;

  slam::CorrectedScan correct(const surfaces::SurfaceScan& scan, const Pose2& T_odom_base,
                              const occupancy::OccupancyMap& map) override;
  slam::RevisionWork takeWork() override;
  bool accept(const slam::MapRevision& revision) override;
  bool refuse(const slam::MapRevision& revision) override;
  void abandonWork() override;
  std::vector<slam::KeyframePose> trajectory() const override;
  void reset() override;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace frontier_pilot::localization
