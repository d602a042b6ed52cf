#pragma once

#include <optional>
#include <string>
#include <vector>

#include "frontier_pilot/patrol/plan.h"

namespace frontier_pilot::patrol {

/// What `patrol_client` was asked for.
struct PatrolCommandLine {
  std::optional<PatrolOrder> goal;  ///< what to patrol; nothing if help was asked for or something was wrong
  bool help = false;
  std::string problem;  ///< what was wrong; empty: nothing
};

/// How patrol_client ends, as its exit code.
enum class PatrolExit { kCompleted = 0, kAborted = 1, kUsage = 2, kNoServer = 3, kInterrupted = 130 };

/// Reads the words after the program's name.
PatrolCommandLine parsePatrolCommandLine(const std::vector<std::string>& words);

/// The text of --help.
const char* patrolUsage();

}  // namespace frontier_pilot::patrol
