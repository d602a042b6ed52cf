#pragma once

#include <memory>
#include <string>
#include <vector>

#include "frontier_pilot/occupancy/parameters.h"
#include "frontier_pilot/slam/parameters.h"
#include "frontier_pilot/slam/pose_correction.h"

namespace frontier_pilot::slam {

/// 2D graph SLAM. The front end matches each scan at once with a submap of the last few metres, in a local frame that
/// is continuous but drifts; the back end closes loops in the background, on a pose graph of submaps. [MAP-1]
/// The map frame equals the local frame until the first loop is closed.
class GraphSlam final : public PoseCorrection {
 public:
  /// The maps of revisions have the parameters `map`, and scans are inserted into them with `insertion`. If `base` is
  /// not empty, it is a map in OctoMap's binary format that every rendering starts from.
  explicit GraphSlam(const GraphSlamParameters& parameters = {}, const occupancy::OccupancyMapParameters& map = {},
                     const occupancy::ScanInsertionParameters& insertion = {}, std::string base = {});
  ~GraphSlam() override;
  GraphSlam(const GraphSlam&) = delete;
  GraphSlam& operator=(const GraphSlam&) = delete;

  CorrectedScan correct(const surfaces::SurfaceScan& scan, const Pose2& T_odom_base,
                        const occupancy::OccupancyMap& map) override;
  Pose2 withoutErrors(const Pose2& motion) const override;
  RevisionWork takeWork() override;
  bool accept(const MapRevision& revision) override;
  bool refuse(const MapRevision& revision) override;
  void abandonWork() override;
  std::vector<KeyframePose> trajectory() const override;
  std::size_t keyframes() const override;
  void reset() override;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace frontier_pilot::slam
