#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace frontier_pilot {

/// Names of nodes by the topic or service that they are registered for.
using NodesByName = std::map<std::string, std::vector<std::string>>;

/// Which nodes are registered for which topics and services at the master. All names are resolved.
struct MasterState {
  NodesByName publishers;   ///< by topic
  NodesByName subscribers;  ///< by topic
  NodesByName providers;    ///< by service; the master keeps one for each
};

/// The state of the master; nothing if it does not answer within two seconds.
std::optional<MasterState> askMaster();

/// The nodes registered for `name`.
std::vector<std::string> nodesOf(const NodesByName& nodes, const std::string& name);
/// Whether `node` is one of them.
bool isNodeOf(const NodesByName& nodes, const std::string& name, const std::string& node);

/// The XML-RPC URI of the node; empty if the master knows none or does not answer.
std::string uriOf(const std::string& node);
/// The address of the service, `rosrpc://host:port`; empty if the master knows none or does not answer.
std::string uriOfService(const std::string& service);

/// Whether the node's process exists, even if it hangs: neither its XML-RPC port nor that of its services refuses
/// connections. A node that was killed stays registered, but its ports refuse them; another process may have got one of
/// the two since, hardly both. Every node of roscpp and rospy has the service `set_logger_level`. Nothing if the master
/// does not answer.
std::optional<bool> lifeOf(const std::string& node);
/// The same; false if the master does not answer.
bool nodeLives(const std::string& node);

/// Whether one of the processes with these XML-RPC URIs may exist, for a thread that must not wait: no name server is
/// asked, and no address for longer than 20 ms. In doubt it may.
bool anyMayLive(const std::set<std::string>& uris);
/// The same for a thread that may wait: names of hosts are looked up, and each address is given 0.3 s.
bool anyMayLivePatiently(const std::set<std::string>& uris);

/// Whether calls of `service` could be answered at the address that the master has for it: not if it refuses
/// connections, and not if its host is unknown here. So a provider that has died is recognised even if its node's own
/// address cannot be asked, because the host's name cannot be resolved or another node has the address now. In doubt,
/// as when the master or the name server does not answer, it may.
bool serviceMayAnswer(const std::string& service);

/// The first of these nodes that lives; empty if none does.
std::string firstLiving(const std::vector<std::string>& nodes);

}  // namespace frontier_pilot
