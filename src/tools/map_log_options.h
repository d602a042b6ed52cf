#pragma once

#include <string>
#include <vector>

#include "frontier_pilot/logs/scan_log.h"
#include "frontier_pilot/mapping/mapper.h"

namespace frontier_pilot::tools {

/// The topics of a rosbag's scans and odometry, and its base frame. A leading slash does not matter.
struct BagTopics {
  std::string scan;  ///< empty: the reader chooses
  std::string odom;  ///< empty: the reader chooses
  std::string base_frame = "base_footprint";
};

/// The parsed command line of `map_log`.
struct MapLogOptions {
  std::string log;
  std::string out;        ///< prefix of the paths of all files that are written
  std::string relations;  ///< empty: none
  logs::LogScanner scanner;
  BagTopics topics;
  mapping::MapperParameters mapper;
};

/// Parses the words after the program's name. Throws std::invalid_argument with what is wrong.
MapLogOptions parseMapLogOptions(const std::vector<std::string>& words);

/// The text of --help.
const char* mapLogUsage();

}  // namespace frontier_pilot::tools
