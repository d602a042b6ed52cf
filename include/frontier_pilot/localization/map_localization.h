#pragma once

#include <memory>
#include <optional>

#include "frontier_pilot/localization/localizer.h"
#include "frontier_pilot/slam/graph_slam.h"

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

  slam::CorrectedScan correct(const LaserScan2& scan, const Pose2& T_odom_base,
                              const occupancy::OccupancyMap& map) override;
  slam::RevisionWork takeWork() override { return slam_ ? slam_->takeWork() : slam::RevisionWork(); }
  bool accept(const slam::MapRevision& revision) override { return slam_ && slam_->accept(revision); }
  bool refuse(const slam::MapRevision& revision) override { return slam_ && slam_->refuse(revision); }
  void abandonWork() override {
    if (slam_) slam_->abandonWork();
  }
  std::vector<slam::KeyframePose> trajectory() const override;
  void reset() override;

 private:
  Use use_;
  Localizer localizer_;
  std::unique_ptr<slam::GraphSlam> slam_;  ///< to go on mapping
  /// Where odometry began when mapping went on. `slam_` is given odometry that begins there, and so it thinks in the
  /// map's frame. None until the robot is found.
  std::optional<Pose2> T_map_odom_;
};

}  // namespace frontier_pilot::localization
