// The start of an arbiter: whether it may start at all, and the stop and the switches that the one before it has left.
#include <ros/console.h>
#include <ros/names.h>
#include <ros/this_node.h>

#include <algorithm>
#include <sstream>
#include <stdexcept>

#include "frontier_pilot/core/bounds.h"
#include "frontier_pilot/core/text.h"
#include "ros/cmd_vel_arbiter/cmd_vel_arbiter_adapter.h"
#include "ros/common/clock.h"
#include "ros/common/master/master_state.h"
#include "ros/common/master/namesake.h"
#include "ros/common/memory/disk.h"
#include "ros/common/names.h"

namespace frontier_pilot {
namespace {

constexpr const char* kRestarted = "from before a restart: ";

/// The cause of a stop by what was kept of it.
std::string causeIn(const std::string& kept) {
  return kept.empty() ? "the file that keeps its cause cannot be read" : printable(kept, bounds::kMostLine);
}

/// How long an arbiter that starts at the same moment may take until it offers its services.
constexpr Duration kElderPatience = std::chrono::seconds(3);

/// The nodes that the master has as providers of the stop services of this namespace's arbiter, and that may answer.
std::vector<std::string> stopProviders(const MasterState& state) {
  std::vector<std::string> found;
  for (const char* name : {names::kEmergencyStop, names::kSetEmergencyStop}) {
    const std::string service = ros::names::resolve(name);
    const std::vector<std::string> providers = nodesOf(state.providers, service);
    if (!providers.empty() && serviceMayAnswer(service)) found.insert(found.end(), providers.begin(), providers.end());
  }
  return found;
}

/// A living node that offers a stop service of this namespace's arbiter; empty if there is none.
std::string findArbiter() {
  const std::optional<MasterState> state = askMaster();
  return state ? firstLiving(stopProviders(*state)) : std::string();
}

/// Those that registered as publishers of the arbiter's status before this node; the master lists them in that order.
std::vector<std::string> eldersIn(const MasterState& state) {
  const std::vector<std::string> nodes = nodesOf(state.publishers, ros::names::resolve(names::kArbiterStatus));
  const auto self = std::find(nodes.begin(), nodes.end(), ros::this_node::getName());
  return self == nodes.end() ? std::vector<std::string>() : std::vector<std::string>(nodes.begin(), self);
}

/// A living arbiter of this namespace that registered at the master before this one; empty if there is none. One that
/// starts at the same moment publishes its status before it offers a stop, so it is waited for. Who never offers one,
/// a player of a recorded run for instance, is no arbiter, and must not keep one from being restarted. [ARB-12]
std::string findElder() {
  std::string stranger;
  for (const SteadyTime end = steadyNow() + kElderPatience; steadyNow() < end && ros::ok();) {
    const std::optional<MasterState> state = askMaster();
    if (!state) return {};
    const std::vector<std::string> elders = eldersIn(*state);
    stranger = firstLiving(elders);
    if (stranger.empty()) return {};
    const std::vector<std::string> providers = stopProviders(*state);
    for (const std::string& elder : elders) {
      const bool offers_a_stop = std::find(providers.begin(), providers.end(), elder) != providers.end();
      if (offers_a_stop && nodeLives(elder)) return elder;
    }
    ros::WallDuration(0.1).sleep();
  }
  ROS_WARN_STREAM(stranger << " publishes " << ros::names::resolve(names::kArbiterStatus)
                           << " but offers no emergency stop: it is not taken for an arbiter");
  return {};
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
  if (const auto kept = memory_.recall()) {
    const std::string cause = causeIn(*kept);
    const bool said = cause.rfind(kRestarted, 0) == 0;  // after more than one restart
    arbiter_.stop((said ? "" : kRestarted) + cause, instantNow());
    ROS_WARN_STREAM("starts stopped, like the arbiter before it: " << cause);
  }
  keepStop();
  publishStopState();
}

void CmdVelArbiterAdapter::restoreCount() {
  const std::string service = node_.resolveName(names::kEmergencyStop);
  stops_.emplace("count_of_stops", service, SessionMemory::Owner::kService, connections_, spareFolder());
  std::uint64_t earlier = 0;
  for (const std::string& text : stops_->left()) {
    std::uint64_t count = 0;
    if (std::istringstream(text) >> count) earlier = std::max(earlier, count);
  }
  arbiter_.countStopsFrom(earlier);
  if (arbiter_.stops() > 0) keepCount();
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
  if (const auto kept = memory_.recallOthers())
    stop("taken over from another arbiter of this namespace: " + causeIn(*kept));
}

void CmdVelArbiterAdapter::restoreSwitch(std::size_t source) {
  const std::string& name = arbiter_.parameters().sources[source].name;
  switches_.emplace_back(name + "_disabled", names::setEnabled(name), connections_);
  if (const auto disabled = switches_.back().wasLeftSafe()) arbiter_.setEnabled(source, !*disabled, instantNow());
}

}  // namespace frontier_pilot
