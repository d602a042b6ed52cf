#pragma once

#include <optional>
#include <string>
#include <vector>

#include "frontier_pilot/patrol/patrol.h"

namespace frontier_pilot::patrol {

/// The parsed command line of `patrol_client`.
struct PatrolCommandLine {
  std::optional<PatrolOrder> goal;  ///< what to patrol; empty if help was asked for or an argument was wrong
  bool help = false;
  std::string problem;  ///< what was wrong; empty if nothing was
};

/// The exit codes of `patrol_client`; interrupted by SIGTERM it is 143.
enum class PatrolExit { kCompleted = 0, kAborted = 1, kUsage = 2, kNoServer = 3, kInterrupted = 130 };

/// Parses the words after the program's name.
PatrolCommandLine parsePatrolCommandLine(const std::vector<std::string>& words);

}  // namespace frontier_pilot::patrol
