// The start of an arbiter: whether it may start at all, and the stop and the switches that the one before it has left.
#include <ros/console.h>
#include <ros/names.h>
#include <ros/this_node.h>

#include <algorithm>
#include <stdexcept>

#include "ros/cmd_vel_arbiter/cmd_vel_arbiter_adapter.h"
#include "ros/common/master/master_state.h"
#include "ros/common/master/namesake.h"
#include "ros/common/names.h"

namespace frontier_pilot {
namespace {

constexpr const char* kRestarted = "from before a restart: ";

/// A living node that publishes the status or offers a stop service of this namespace's arbiter; empty if there is
/// none.
std::string findArbiter() {
  const std::optional<MasterState> state = askMaster();
  if (!state) return {};
  std::vector<std::string> found = nodesOf(state->publishers, ros::names::resolve(names::kArbiterStatus));
  for (const char* name : {names::kEmergencyStop, names::kSetEmergencyStop}) {
    const std::string service = ros::names::resolve(name);
    const std::vector<std::string> providers = nodesOf(state->providers, service);
    if (!providers.empty() && serviceMayAnswer(service)) found.insert(found.end(), providers.begin(), providers.end());
  }
  return firstLiving(found);
}

/// A living arbiter of this namespace that registered at the master before this one; empty if there is none.
std::string findElder() {
  const std::optional<MasterState> state = askMaster();
  if (!state) return {};
  const std::vector<std::string> nodes = nodesOf(state->publishers, ros::names::resolve(names::kArbiterStatus));
  // The master lists publishers in the order in which they registered.
  const auto self = std::find(nodes.begin(), nodes.end(), ros::this_node::getName());
  return self == nodes.end() ? std::string() : firstLiving({nodes.begin(), self});
}

void endBeside(const std::string& other) {
  if (other.empty()) return;
  throw std::runtime_error(other + " is already the arbiter of this namespace: two arbiters would both command the " +
                           "base, and an emergency stop would reach only one of them. End that one first");
}

}  // namespace

void refuseASecondArbiter() { endBeside(waitUntilGone(findArbiter)); }

ros::Publisher CmdVelArbiterAdapter::takeItsPlace(ros::NodeHandle& node) {
  ros::Publisher status = node.advertise<ArbiterStatus>(names::kArbiterStatus, 1, true);
  endBeside(findElder());
  return status;
}

void CmdVelArbiterAdapter::restoreStop() {
  if (const auto cause = memory_.recall()) {
    const bool said = cause->rfind(kRestarted, 0) == 0;  // after more than one restart
    arbiter_.stop((said ? "" : kRestarted) + *cause, instantNow());
    ROS_WARN_STREAM("starts stopped, like the arbiter before it: " << *cause);
  }
  keepStop();
  publishStopState();
}

void CmdVelArbiterAdapter::keepStop() {
  // Called repeatedly, because a disk may be full for a while, and files may be deleted or may not be removable.
  if (arbiter_.stopped()) around_.memory_problem = memory_.remember(arbiter_.stopCause());
  if (!arbiter_.stopped() && !around_.memory_problem.empty()) around_.memory_problem = memory_.forget();
  connections_.memory().setProblem("an emergency stop",
                                   arbiter_.stopped() ? around_.memory_problem : memory_.problem());
}

void CmdVelArbiterAdapter::takeOverStop() {
  // Files that could not be removed when the stop was cleared must be ignored.
  if (arbiter_.stopped() || !around_.memory_problem.empty()) return;
  if (const auto cause = memory_.recallOthers()) stop("taken over from another arbiter of this namespace: " + *cause);
}

void CmdVelArbiterAdapter::restoreSwitch(std::size_t source) {
  const std::string& name = arbiter_.parameters().sources[source].name;
  switches_.emplace_back(name + "_disabled", names::setEnabled(name), connections_);
  if (const auto disabled = switches_.back().wasLeftSafe()) arbiter_.setEnabled(source, !*disabled, instantNow());
}

}  // namespace frontier_pilot
