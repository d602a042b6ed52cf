#pragma once

#include <diagnostic_updater/DiagnosticStatusWrapper.h>
#include <frontier_pilot/ArbiterStatus.h>

#include <map>
#include <string>
#include <vector>

#include "frontier_pilot/arbiter/status.h"
#include "ros/common/master/master_state.h"

namespace frontier_pilot {

/// What the node knows about topics, services and the master, in addition to the arbiter's own state.
struct ArbiterConnections {
  std::string own_name;
  std::string cmd_vel, status, emergency_stop_state;  ///< resolved topics
  std::map<std::string, std::string> source_topics;   ///< resolved, by source
  NodesByName publishers;                             ///< by topic
  std::map<std::string, std::string> rivals;          ///< by service or topic of the arbiter: another node that has it
  std::vector<std::string> registration_problems;     ///< one sentence each
  bool master_answers = true;
  std::string memory_problem;  ///< why a stop would not survive the node; empty if it would
  std::string fleet_problem;   ///< why a stop of the whole fleet would not reach this robot; empty if it would
};

/// A problem with its severity, a level of diagnostic_msgs/DiagnosticStatus.
struct ArbiterProblem {
  unsigned char level = 0;
  std::string text;
};

/// Everything that is wrong, in no particular order of severity.
std::vector<ArbiterProblem> findProblems(const arbiter::ArbiterSnapshot& snapshot, const ArbiterConnections& around);

/// The status message.
ArbiterStatus toStatusMsg(const arbiter::ArbiterSnapshot& snapshot, const ArbiterConnections& around);

/// The part of a status whose change is worth a message of its own: everything but ages, rates, counts and velocities.
std::string contentOf(const ArbiterStatus& status);

/// The most important of it, for /diagnostics.
void fillDiagnostics(const arbiter::ArbiterSnapshot& snapshot, const ArbiterConnections& around,
                     diagnostic_updater::DiagnosticStatusWrapper& diagnostics);

}  // namespace frontier_pilot
