#pragma once

#include <string>
#include <vector>

#include "frontier_pilot/logs/scan_log.h"
#include "frontier_pilot/mapping/mapper.h"

namespace frontier_pilot::tools {

/// Where a rosbag has its scans and its odometry. A leading slash does not matter.
struct BagTopics {
  std::string scan = "scan";
  std::string odom = "odom";
  std::string base_frame = "base_footprint";
};

/// What `map_log` was asked for.
struct MapLogOptions {
  bool help = false;
  std::string log;
  std::string out;        ///< what the written files' names begin with
  std::string relations;  ///< empty: none
  logs::LogScanner scanner;
  BagTopics topics;
  mapping::MapperParameters mapper;
};

/// Reads the words after the program's name. Throws std::invalid_argument with what is wrong.
MapLogOptions parseMapLogOptions(const std::vector<std::string>& words);

/// The text of --help.
const char* mapLogUsage();

}  // namespace frontier_pilot::tools
