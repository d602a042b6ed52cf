#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace frontier_pilot {

/// Names of nodes by what they are registered for.
using NodesByName = std::map<std::string, std::vector<std::string>>;

/// Who is registered for what, as the master has it. All names are resolved.
struct MasterState {
  NodesByName publishers;   ///< by topic
  NodesByName subscribers;  ///< by topic
  NodesByName providers;    ///< by service; the master keeps one for each
};

/// Nothing if the master does not answer. Does not wait for it.
std::optional<MasterState> askMaster();

/// The nodes registered for `name`.
std::vector<std::string> nodesOf(const NodesByName& nodes, const std::string& name);

/// Whether the node is reachable, or merely hangs: its XML-RPC port takes connections. A node that was killed stays
/// registered, and its port refuses them.
bool nodeLives(const std::string& node);

/// The first of these nodes that lives; empty if none does.
std::string firstLiving(const std::vector<std::string>& nodes);

}  // namespace frontier_pilot
