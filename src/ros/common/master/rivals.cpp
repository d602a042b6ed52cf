#include "ros/common/master/rivals.h"

#include <ros/this_node.h>

#include <algorithm>

namespace frontier_pilot {
namespace {

/// Whether a node lives, asked once in a look.
using LivingNodes = std::map<std::string, bool>;

bool lives(const std::string& node, LivingNodes& known) {
  const auto [entry, unknown] = known.try_emplace(node);
  if (unknown) entry->second = nodeLives(node);
  return entry->second;
}

/// Another living node of `nodes`; empty if there is none.
std::string findOther(const std::vector<std::string>& nodes, LivingNodes& known) {
  for (const std::string& node : nodes) {
    if (node != ros::this_node::getName() && lives(node, known)) return node;
  }
  return {};
}

/// The nodes that publish all of `topics`.
std::vector<std::string> publishersOfAll(const std::vector<std::string>& topics, const NodesByName& publishers) {
  std::vector<std::string> nodes = nodesOf(publishers, topics.front());
  const auto lacksOne = [&](const std::string& node) {
    return !std::all_of(topics.begin(), topics.end(),
                        [&](const std::string& topic) { return isNodeOf(publishers, topic, node); });
  };
  nodes.erase(std::remove_if(nodes.begin(), nodes.end(), lacksOne), nodes.end());
  return nodes;
}

}  // namespace

std::map<std::string, std::string> findRivals(const Claims& claims, const MasterState& state) {
  LivingNodes known;
  std::map<std::string, std::string> rivals;
  for (const std::string& service : claims.services) {
    const std::string other = findOther(nodesOf(state.providers, service), known);
    if (!other.empty() && serviceMayAnswer(service)) rivals[service] = other;
  }
  for (const auto& topics : claims.topics) {
    const std::string other = findOther(publishersOfAll(topics, state.publishers), known);
    if (!other.empty()) rivals[topics.front()] = other;
  }
  return rivals;
}

}  // namespace frontier_pilot
