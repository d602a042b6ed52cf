#pragma once

#include <memory>
#include <string>
#include <vector>

#include "frontier_pilot/occupancy/parameters.h"
#include "frontier_pilot/slam/parameters.h"
#include "frontier_pilot/slam/pose_correction.h"

namespace frontier_pilot::slam {

/// Simultaneous localisation and mapping: scans are matched with the last few metres at once, in a local frame that is
/// smooth and drifts; loops are closed in the background, on a pose graph of submaps. [MAP-1]
/// The map's frame is the local one as long as no loop was closed.
class GraphSlam final : public PoseCorrection {
 public:
  /// The map that revisions bring has `map` as its parameters, scans go into it by `insertion`, and it begins with
  /// `base`, a map in OctoMap's binary format, if there is one.
  explicit GraphSlam(const GraphSlamParameters& parameters = {}, const occupancy::OccupancyMapParameters& map = {},
                     const occupancy::ScanInsertionParameters& insertion = {}, const std::string& base = {});
  ~GraphSlam() override;
  GraphSlam(const GraphSlam&) = delete;
  GraphSlam& operator=(const GraphSlam&) = delete;

  CorrectedScan correct(const surfaces::SurfaceScan& scan, const Pose2& T_odom_base,
                        const occupancy::OccupancyMap& map) override;
  RevisionWork takeWork() override;
  bool accept(const MapRevision& revision) override;
  bool refuse(const MapRevision& revision) override;
  void abandonWork() override;
  std::vector<KeyframePose> trajectory() const override;
  void reset() override;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace frontier_pilot::slam
