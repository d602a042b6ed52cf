#include "ros/common/master/namesake.h"

#include <ros/master.h>
#include <ros/names.h>
#include <ros/this_node.h>

#include <algorithm>
#include <chrono>
#include <stdexcept>
#include <thread>

#include "ros/common/clock.h"
#include "ros/common/master/local_name.h"
#include "ros/common/master/master_state.h"
#include "ros/common/master/xml_rpc.h"
#include "ros/common/names.h"

namespace frontier_pilot {
namespace {

constexpr Duration kLastWords = std::chrono::seconds(2);
constexpr std::chrono::milliseconds kLook(200);

/// The first of `nodes` that lives and is not this one; empty if there is none.
std::string firstLivingOther(std::vector<std::string> nodes) {
  nodes.erase(std::remove(nodes.begin(), nodes.end(), ros::this_node::getName()), nodes.end());
  return firstLiving(nodes);
}

/// A living node, other than this one, that offers `service`; empty if there is none.
std::string findOtherProvider(const char* service) {
  const std::optional<MasterState> state = askMaster();
  return state ? firstLivingOther(nodesOf(state->providers, ros::names::resolve(service))) : "";
}

/// A living node, other than this one, that takes the goals of `action` and publishes results; empty if there is none.
std::string findOtherServer(const char* action) {
  const std::optional<MasterState> state = askMaster();
  if (!state) return {};
  const auto topic = [name = ros::names::resolve(action)](const char* end) { return ros::names::resolve(name + end); };
  std::vector<std::string> nodes = nodesOf(state->publishers, topic("/result"));
  const auto takes_no_goals = [&state, goals = topic(names::kGoalOfAction)](const std::string& node) {
    return !isNodeOf(state->subscribers, goals, node);
  };
  nodes.erase(std::remove_if(nodes.begin(), nodes.end(), takes_no_goals), nodes.end());
  return firstLivingOther(nodes);
}

/// Throws if `find` goes on giving a node that does `what`, because of which this one must not start beside it, for the
/// reason `why`.
void refuseBeside(const std::function<std::string()>& find, const std::string& what, const std::string& why) {
  const std::string other = waitUntilGone(find);
  if (other.empty()) return;
  throw std::runtime_error(other + " " + what + " already: " + why + ". End that one first (rosnode kill " + other +
                           ")");
}

/// Takes back what `node` is registered for under these names. False if the master does not answer.
bool unregister(const char* method, const NodesByName& registered, const std::string& node,
                const std::function<std::string(const std::string&)>& addressOf) {
  for (const auto& [name, nodes] : registered) {
    if (std::find(nodes.begin(), nodes.end(), node) == nodes.end()) continue;
    XmlRpc::XmlRpcValue request;
    request[0] = node;
    request[1] = name;
    request[2] = addressOf(name);
    if (!requestFromMaster(method, request)) return false;
  }
  return true;
}

/// Takes back the registrations of a node with this one's name that was killed. Otherwise the master would ask whatever
/// process listens at its address now to shut down, and that may be another node.
void unregisterTheDead(const std::string& self) {
  std::string uri = uriOf(self);
  if (uri.empty()) return;
  const std::optional<MasterState> state = askMaster();
  if (!state) return;
  const auto of_node = [&uri](const std::string&) { return uri; };
  // One after the other: a master that hangs is waited for once.
  if (!unregister("unregisterService", state->providers, self, uriOfService)) return;
  if (!unregister("unregisterPublisher", state->publishers, self, of_node)) return;
  unregister("unregisterSubscriber", state->subscribers, self, of_node);
}

}  // namespace

std::string waitUntilGone(const std::function<std::string()>& find) {
  const SteadyTime end = steadyNow() + kLastWords;
  std::string other = find();
  while (!other.empty() && steadyNow() < end) {
    std::this_thread::sleep_for(kLook);
    other = find();
  }
  return other;
}

void refuseANamesake() {
  const std::string& self = ros::this_node::getName();
  // Kept until the process ends.
  static LocalName name(ros::master::getURI() + ' ' + self);
  const bool is_new_here = waitUntilGone([&self] { return name.take() ? std::string() : self; }).empty();
  if (is_new_here && waitUntilGone([&self] { return nodeLives(self) ? self : std::string(); }).empty())
    return unregisterTheDead(self);
  std::string process, remedy = "rosnode kill " + self;
  const int owner = is_new_here ? 0 : name.owner();
  if (owner > 0) {
    process = " as process " + std::to_string(owner);
    remedy = "kill " + std::to_string(owner);
  }
  throw std::runtime_error("a node " + self + " is already running" + process + ", and ROS would shut it down for " +
                           "this one: end it first (" + remedy + "), or give this one another name (__name:=...)");
}

void refuseASecondProvider(const char* service) {
  refuseBeside([service] { return findOtherProvider(service); }, "offers " + ros::names::resolve(service),
               "its callers would reach only one of the two nodes");
}

void refuseASecondServer(const char* action) {
  refuseBeside([action] { return findOtherServer(action); }, "serves the action " + ros::names::resolve(action),
               "both nodes would drive to each of its goals");
}

}  // namespace frontier_pilot
