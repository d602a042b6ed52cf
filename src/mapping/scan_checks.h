#pragma once

#include "frontier_pilot/core/laser_scan.h"
#include "frontier_pilot/mapping/mapper.h"
#include "frontier_pilot/occupancy/scan_inserter.h"

namespace frontier_pilot::mapping {

/// Whether geometry and mount of `scan` are those of a scan, and within the bounds that the mapper works in.
bool isWellFormed(const LaserScan2& scan);

/// Whether a pose by odometry is finite and within the bounds.
bool isUsable(const Pose2& T_odom_base);

/// Whether the scan got as far as to the correction of its pose.
bool wasCorrected(ScanVerdict verdict);

/// What inserting a scan into the map means for the scan.
ScanVerdict verdictOf(occupancy::Insertion insertion);

}  // namespace frontier_pilot::mapping
