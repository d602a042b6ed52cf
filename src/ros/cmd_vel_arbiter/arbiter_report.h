#pragma once

#include <diagnostic_updater/DiagnosticStatusWrapper.h>
#include <frontier_pilot/ArbiterStatus.h>

#include <map>
#include <string>
#include <vector>

#include "frontier_pilot/arbiter/status.h"
#include "ros/common/master/master_state.h"

namespace frontier_pilot {

/// What the arbiter's node knows beyond the arbiter itself.
struct ArbiterConnections {
  std::string own_name;
  std::string cmd_vel, status, emergency_stop_state;  ///< resolved topics
  std::map<std::string, std::string> source_topics;   ///< resolved, by source
  NodesByName publishers;                             ///< by topic
  std::map<std::string, std::string> rivals;          ///< by service or topic of the arbiter alone: who has it too
  std::vector<std::string> registration_problems;     ///< one sentence each
  bool master_answers = true;
  std::string memory_problem;  ///< why a stop would not survive the node; empty: it would
};

/// Something wrong, and how much: a level of diagnostic_msgs/DiagnosticStatus.
struct ArbiterProblem {
  unsigned char level = 0;
  std::string text;
};

/// Everything that is wrong, errors before warnings.
std::vector<ArbiterProblem> findProblems(const arbiter::ArbiterSnapshot& snapshot, const ArbiterConnections& around);

/// The status for the wire, in words.
ArbiterStatus toStatusMsg(const arbiter::ArbiterSnapshot& snapshot, const ArbiterConnections& around);

/// What in a status makes it a change: all but ages, rates, counts and velocities.
std::string contentOf(const ArbiterStatus& status);

/// The same at a glance, for /diagnostics.
void fillDiagnostics(const arbiter::ArbiterSnapshot& snapshot, const ArbiterConnections& around,
                     diagnostic_updater::DiagnosticStatusWrapper& diagnostics);

}  // namespace frontier_pilot
