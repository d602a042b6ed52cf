// Whether an arbiter may start at all.
#include <ros/names.h>
#include <ros/this_node.h>

#include <algorithm>
#include <stdexcept>

#include "frontier_pilot/ros/cmd_vel_arbiter_adapter.h"
#include "frontier_pilot/ros/master_state.h"
#include "frontier_pilot/ros/names.h"
#include "frontier_pilot/ros/namesake.h"

namespace frontier_pilot {
namespace {

/// A living node that offers what only the arbiter of this namespace offers; empty if there is none.
std::string findArbiter() {
  const std::optional<MasterState> state = askMaster();
  if (!state) return {};
  std::vector<std::string> found = nodesOf(state->publishers, ros::names::resolve(names::kArbiterStatus));
  for (const char* service : {names::kEmergencyStop, names::kSetEmergencyStop}) {
    const std::vector<std::string> providers = nodesOf(state->providers, ros::names::resolve(service));
    found.insert(found.end(), providers.begin(), providers.end());
  }
  const auto living = std::find_if(found.begin(), found.end(), nodeLives);
  return living == found.end() ? std::string() : *living;
}

}  // namespace

void refuseASecondArbiter() {
  const std::string other = waitUntilGone(findArbiter);
  if (other.empty()) return;
  throw std::runtime_error(other + " is an arbiter of this namespace already: two of them would take turns at the " +
                           "wheels, and only one could be stopped. End that one first");
}

}  // namespace frontier_pilot
