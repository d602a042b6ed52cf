#pragma once

#include <optional>

#include "frontier_pilot/slam/pose_correction.h"

namespace frontier_pilot::localization {

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
