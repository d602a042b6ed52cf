#pragma once

#include <chrono>
#include <cstdint>
#include <string>

#include "frontier_pilot/logs/scan_log.h"
#include "tools/map_log_options.h"

namespace frontier_pilot {

/// Reads the scans of a rosbag, each with the odometry at its stamp and without its jumps, as the mapper does: messages
/// that the mapper would drop are left out and counted in the notes. The scanner's mount comes from the bag's TF. No
/// master is needed. Throws a LogError if the bag cannot be read or contains no usable scan.
logs::ScanLog readBagLog(const std::string& path, const tools::BagTopics& topics);

/// Limits of the process that reads a bag.
struct BagReadLimits {
  std::uint64_t memory = std::uint64_t{4} << 30U;          ///< in addition to what the program uses already [bytes]
  std::chrono::seconds time = std::chrono::seconds(1800);  ///< steady time
};

/// `readBagLog` in a process of its own, because rosbag's code may crash on a broken file: a crash, an abort or a use
/// of more than `limits` allow becomes a LogError, too. [FLT-1]
logs::ScanLog readBagLogApart(const std::string& path, const tools::BagTopics& topics,
                              const BagReadLimits& limits = {});

}  // namespace frontier_pilot
