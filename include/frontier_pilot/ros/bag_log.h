#pragma once

#include <string>

#include "frontier_pilot/logs/scan_log.h"
#include "frontier_pilot/tools/map_log_options.h"

namespace frontier_pilot {

/// Reads the scans of a rosbag, each with the odometry of its stamp, as the mapper would: what it would drop is left
/// out and counted in the notes. Where the scanner sits comes from the bag's TF. No master is needed. Throws a LogError
/// when the bag cannot be read or holds no usable scan.
ScanLog readBagLog(const std::string& path, const BagTopics& topics);

}  // namespace frontier_pilot
