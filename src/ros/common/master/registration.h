#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>

namespace frontier_pilot {

/// The addresses (XML-RPC URIs) of nodes, by topic.
using UrisByTopic = std::map<std::string, std::set<std::string>>;

/// The port at which this node takes connections of topics and services.
std::uint32_t tcpPort();
/// Whether the master has another process under this node's name, and that process answers, or has shut this node down
/// for one. To register that name would make the master shut the other one down.
bool nameIsTaken();
/// Registers this node at the master again, for a publisher or service that it already has; roscpp itself registers
/// only once. Names are resolved. Existing connections stay as they are. False if the master does not accept it.
bool registerPublisher(const std::string& topic);
bool registerService(const std::string& service);
/// Whether the master has the address of this process for `service`; true also if it does not answer.
bool pointsHere(const std::string& service);
/// The addresses listed for `topic`.
std::set<std::string> urisOf(const UrisByTopic& uris, const std::string& topic);

/// The publishers that this node is connected to; nothing if its own XML-RPC server does not say so within two seconds.
std::optional<UrisByTopic> connectedPublishers();
/// Registers this node at the master again as a subscriber, and connects to publishers that the master knows and that
/// are not in `connected`, which is what `connectedPublishers` gave; if that was nothing, it is only registered. False
/// if the master does not accept it, or this node's own XML-RPC server does not take the publishers.
bool registerSubscriber(const std::string& topic, const std::optional<UrisByTopic>& connected);

}  // namespace frontier_pilot
