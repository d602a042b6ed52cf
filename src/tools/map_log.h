#pragma once

#include <functional>
#include <string>
#include <vector>

#include "frontier_pilot/logs/scan_log.h"
#include "tools/map_log_options.h"

namespace frontier_pilot::tools {

/// Reads the rosbag at `path`. Throws a LogError.
using BagReader = std::function<logs::ScanLog(const std::string& path, const BagTopics& topics)>;

/// The program `map_log`: `words` are the arguments after its name. Without `read_bag` rosbags are refused. Returns the
/// exit code.
int runMapLog(const std::vector<std::string>& words, const BagReader& read_bag = {});

}  // namespace frontier_pilot::tools
