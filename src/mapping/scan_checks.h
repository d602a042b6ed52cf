#pragma once

#include "frontier_pilot/core/laser_scan.h"
#include "frontier_pilot/mapping/mapper.h"
#include "frontier_pilot/occupancy/scan_inserter.h"

namespace frontier_pilot::mapping {

/// Whether geometry and mount of `scan` are those of a scan, and within the bounds that the mapper works in.
bool isWellFormed(const LaserScan2& scan);

/// Whether the scan sees none of the walls that the map has all around `T_map_base`, the pose before matching: such a
/// scan has nothing by which a match could correct it.
bool isBlind(const LaserScan2& scan, const Pose2& T_map_base, const occupancy::OccupancyMap& map);

/// Whether a pose by odometry is finite and within the bounds.
bool isUsable(const Pose2& T_odom_base);

/// What inserting a scan into the map means for the scan.
ScanVerdict verdictOf(occupancy::Insertion insertion);

}  // namespace frontier_pilot::mapping
