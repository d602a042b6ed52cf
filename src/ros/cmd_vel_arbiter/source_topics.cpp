#include "ros/cmd_vel_arbiter/source_topics.h"

#include <ros/names.h>

#include <algorithm>
#include <map>
#include <string>

#include "ros/common/names.h"
#include "ros/common/parameters.h"

namespace frontier_pilot {
namespace {

bool isName(const std::string& topic) {
  std::string why;
  return topic.front() != '~' && ros::names::validate(topic, why);
}

/// Whether the arbiter publishes `topic`, a whole name, itself.
bool isOwn(const std::string& topic, const ros::NodeHandle& node) {
  const auto own = {names::kCmdVel, names::kEmergencyStopState, names::kArbiterStatus};
  return std::any_of(own.begin(), own.end(), [&](const char* name) { return topic == node.resolveName(name); });
}

}  // namespace

arbiter::ArbiterParameters loadArbiterParameters(const ros::NodeHandle& node, const ros::NodeHandle& private_node) {
  auto parameters = loadNodeParameters<arbiter::ArbiterParameters>(private_node);
  Problems problems;
  if (const std::string& topic = parameters.fleet_stop_status; !topic.empty() && !isName(topic))
    problems.push_back("fleet_stop_status: '" + topic + "' is not a name of ROS");
  std::map<std::string, std::string> owners;  // of the resolved topics
  for (std::size_t i = 0; i < parameters.sources.size(); ++i) {
    const arbiter::SourceParameters& source = parameters.sources[i];
    const std::string what = "sources[" + std::to_string(i) + "]/topic: '" + source.topic + "' ";
    if (!isName(source.topic)) {
      problems.push_back(what + "is not a name of ROS");
      continue;
    }
    const std::string topic = node.resolveName(source.topic);
    const auto [owner, is_new] = owners.try_emplace(topic, source.name);
    if (isOwn(topic, node)) problems.push_back(what + "is what the arbiter itself publishes");
    if (!is_new) problems.push_back(what + "belongs to '" + owner->second + "' already");
  }
  if (!problems.empty()) throw ConfigurationError(private_node.getNamespace(), problems);
  return parameters;
}

}  // namespace frontier_pilot
