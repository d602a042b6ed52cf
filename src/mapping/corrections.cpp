#include "mapping/corrections.h"

#include <algorithm>

#include "frontier_pilot/core/bounds.h"
#include "frontier_pilot/localization/map_localization.h"
#include "frontier_pilot/slam/graph_slam.h"
#include "frontier_pilot/surfaces/surface_points.h"

namespace frontier_pilot::mapping {

scan_matching::PoseWithCovariance beliefOf(const Pose2& pose) {
  constexpr double kPosition = 0.5;  // [m]
  constexpr double kYaw = 0.25;      // [rad]
  return {pose, Eigen::Vector3d(kPosition * kPosition, kPosition * kPosition, kYaw * kYaw).asDiagonal()};
}

bool canBeKnown(const occupancy::OccupancyMap& map, const MapperParameters& parameters) {
  const GridGeometry& box = map.geometry();
  const double finer = std::max(1.0, box.resolution / parameters.slam.local.likelihood.resolution);
  return static_cast<double>(box.size()) * square(finer) <= static_cast<double>(bounds::kMostMapCells) &&
         surfaces::surfaceSize(map.projection()) <= bounds::kMostSurfacePoints;
}

std::unique_ptr<slam::PoseCorrection> knownMap(const MapperParameters& parameters, occupancy::OccupancyMap& map,
                                               const scan_matching::PoseWithCovariance& T_map_base,
                                               const std::optional<Pose2>& T_odom_base) {
  auto use = parameters.trust_odometry ? localization::MapLocalization::Use::kTrustOdometry
                                       : localization::MapLocalization::Use::kGoOnMapping;
  if (parameters.localize_only) use = localization::MapLocalization::Use::kLocalizeOnly;
  return std::make_unique<localization::MapLocalization>(use, parameters.slam, map, parameters.insertion, T_map_base,
                                                         T_odom_base);
}

std::unique_ptr<slam::PoseCorrection> correctionFor(const MapperParameters& parameters, occupancy::OccupancyMap& map) {
  if (parameters.localize_only) return knownMap(parameters, map, beliefOf(Pose2()), std::nullopt);
  if (parameters.trust_odometry) return std::make_unique<localization::TrustedOdometry>();
  return std::make_unique<slam::GraphSlam>(parameters.slam, parameters.map, parameters.insertion);
}

LaserScan2 withoutErrors(const slam::PoseCorrection& correction, LaserScan2 scan) {
  const Pose2 T_sensor_base = scan.T_base_sensor.inverse();
  for (Pose2& mount : scan.moving_mounts) {
    mount = correction.withoutErrors(mount * T_sensor_base) * scan.T_base_sensor;
  }
  return scan;
}

}  // namespace frontier_pilot::mapping
