#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "frontier_pilot/occupancy/parameters.h"
#include "frontier_pilot/scan_matching/scan_matcher.h"
#include "frontier_pilot/slam/parameters.h"
#include "frontier_pilot/slam/pose_correction.h"

namespace frontier_pilot::localization {

/// Localisation in a known map: finds the robot in it, and then either follows it there and leaves the map as it is, or
/// goes on mapping. When mapping goes on, new scans are matched with each other, and drawn on the known map. Until the
/// robot is found no scan is used.
/// [MAP-5]
class MapLocalization final : public slam::PoseCorrection {
 public:
  enum class Use {
    kLocalizeOnly,   ///< the map stays as it is
    kGoOnMapping,    ///< with scan matching and loop closing
    kTrustOdometry,  ///< with odometry taken for the truth from where the robot was found
  };

  /// `map` is the known one; revised maps get its parameters. `T_map_base` is a rough pose of the robot now.
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
