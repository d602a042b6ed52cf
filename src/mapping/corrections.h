#pragma once

#include <memory>
#include <optional>

#include "frontier_pilot/core/geometry.h"
#include "frontier_pilot/core/laser_scan.h"
#include "frontier_pilot/mapping/parameters.h"
#include "frontier_pilot/occupancy/occupancy_map.h"
#include "frontier_pilot/scan_matching/scan_matcher.h"
#include "frontier_pilot/slam/pose_correction.h"

namespace frontier_pilot::mapping {

/// An uncertain `pose` of the robot, with standard deviations of 0.5 m and 0.25 rad.
scan_matching::PoseWithCovariance beliefOf(const Pose2& pose);

/// Whether the robot may be localised in `map`, which keeps dense grids over its box, of up to 11 bytes for each of the
/// map's cells or of those that scans are matched in, whichever are smaller, and all borders between its walls and free
/// space.
bool canBeKnown(const occupancy::OccupancyMap& map, const MapperParameters& parameters);

/// The corrector that the parameters determine for a robot at about `T_map_base` in a known map, where odometry has it
/// at `T_odom_base`; if that is not known, at the first scan. Keeps no reference to `map`.
std::unique_ptr<slam::PoseCorrection> knownMap(const MapperParameters& parameters, occupancy::OccupancyMap& map,
                                               const scan_matching::PoseWithCovariance& T_map_base,
                                               const std::optional<Pose2>& T_odom_base);

/// The corrector that the parameters determine at the start, when `map` is still empty.
std::unique_ptr<slam::PoseCorrection> correctionFor(const MapperParameters& parameters, occupancy::OccupancyMap& map);

/// `scan` with its beams placed by odometry without the systematic errors that `correction` knows of. [SCN-1]
LaserScan2 withoutErrors(const slam::PoseCorrection& correction, LaserScan2 scan);

}  // namespace frontier_pilot::mapping
