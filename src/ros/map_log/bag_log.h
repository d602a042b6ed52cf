#pragma once

#include <chrono>
#include <cstdint>
#include <string>

#include "frontier_pilot/logs/scan_log.h"
#include "tools/map_log_options.h"

namespace frontier_pilot {

/// Reads the scans of a rosbag, each with the odometry of its stamp, as the mapper would: what it would drop is left
/// out and counted in the notes. Where the scanner sits comes from the bag's TF. No master is needed. Throws a LogError
/// when the bag cannot be read or holds no usable scan.
logs::ScanLog readBagLog(const std::string& path, const tools::BagTopics& topics);

/// What reading a bag may take.
struct BagReadLimits {
  std::uint64_t memory = std::uint64_t{4} << 30U;          ///< on top of what the program has anyway [bytes]
  std::chrono::seconds time = std::chrono::seconds(1800);  ///< by the clock on the wall
};

/// `readBagLog` in a process of its own, because rosbag's code does not survive every broken file: where it crashes,
/// aborts, or takes more than `limits` allow, that becomes a LogError too. [FLT-1]
logs::ScanLog readBagLogApart(const std::string& path, const tools::BagTopics& topics,
                              const BagReadLimits& limits = {});

}  // namespace frontier_pilot
