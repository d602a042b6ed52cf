#pragma once

#include <memory>

#include "frontier_pilot/core/geometry.h"
#include "frontier_pilot/mapping/parameters.h"
#include "frontier_pilot/occupancy/occupancy_map.h"
#include "frontier_pilot/scan_matching/scan_matcher.h"
#include "frontier_pilot/slam/pose_correction.h"

namespace frontier_pilot::mapping {

/// A robot that is about at `pose`: within half a metre and a quarter of a radian, by one standard deviation.
scan_matching::PoseWithCovariance beliefOf(const Pose2& pose);

/// What the parameters choose for a robot at about `T_map_base` in a map that is known. Keeps nothing of `map`.
std::unique_ptr<slam::PoseCorrection> knownMap(const MapperParameters& parameters, occupancy::OccupancyMap& map,
                                               const scan_matching::PoseWithCovariance& T_map_base);

/// What they choose to begin with, where `map` is still empty.
std::unique_ptr<slam::PoseCorrection> correctionFor(const MapperParameters& parameters, occupancy::OccupancyMap& map);

}  // namespace frontier_pilot::mapping
