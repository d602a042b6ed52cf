#include "ros/common/master/registration.h"

#include <ros/connection_manager.h>
#include <ros/network.h>
#include <ros/publication.h>
#include <ros/this_node.h>
#include <ros/topic_manager.h>
#include <ros/xmlrpc_manager.h>

#include "ros/common/master/master_state.h"
#include "ros/common/master/slave_api.h"
#include "ros/common/master/xml_rpc.h"

namespace frontier_pilot {
namespace {

using Value = XmlRpc::XmlRpcValue;

const std::string& ownUri() { return ros::XMLRPCManager::instance()->getServerURI(); }

std::string ownServiceUri() { return "rosrpc://" + ros::network::getHost() + ":" + std::to_string(tcpPort()); }

/// The registration calls of the master API differ in the argument between the name and this node's URI.
std::optional<Value> askMasterApi(const char* method, const std::string& name, const std::string& detail) {
  Value request;
  request[0] = ros::this_node::getName();
  request[1] = name;
  request[2] = detail;
  request[3] = ownUri();
  return requestFromMaster(method, request);
}

/// Calls a method of this node's own slave API over XML-RPC: roscpp has no function for it within the process.
std::optional<Value> askSlaveApi(const char* method, const Value& arguments) {
  std::string host;
  std::uint32_t port = 0;
  if (!ros::network::splitURI(ownUri(), host, port)) return std::nullopt;
  return requestFrom(host, port, method, arguments);
}

/// Tells this node which nodes publish `topic` now, as the master does by `publisherUpdate`.
bool updatePublishers(const std::string& topic, const std::set<std::string>& uris) {
  Value arguments;
  arguments[0] = ros::this_node::getName();
  arguments[1] = topic;
  arguments[2].setSize(0);
  int i = 0;
  for (const std::string& uri : uris) arguments[2][i++] = uri;
  return askSlaveApi("publisherUpdate", arguments).has_value();
}

}  // namespace

std::set<std::string> urisOf(const UrisByTopic& uris, const std::string& topic) {
  const auto found = uris.find(topic);
  return found == uris.end() ? std::set<std::string>() : found->second;
}

std::uint32_t tcpPort() { return ros::ConnectionManager::instance()->getTCPPort(); }

bool nameIsTaken() {
  if (isReplaced()) return true;
  const std::string uri = uriOf(ros::this_node::getName());
  std::string host;
  std::uint32_t port = 0;
  if (uri.empty() || uri == ownUri() || !ros::network::splitURI(uri, host, port)) return false;
  Value arguments;
  arguments[0] = ros::this_node::getName();
  return requestFrom(host, port, "getPid", arguments).has_value();
}

bool registerPublisher(const std::string& topic) {
  const ros::PublicationPtr publication = ros::TopicManager::instance()->lookupPublication(topic);
  return publication && askMasterApi("registerPublisher", topic, publication->getDataType());
}

bool registerService(const std::string& service) {
  return askMasterApi("registerService", service, ownServiceUri()).has_value();
}

bool pointsHere(const std::string& service) {
  Value request;
  request[0] = ros::this_node::getName();
  request[1] = service;
  std::optional<Value> uri = requestFromMaster("lookupService", request);
  if (!uri || uri->getType() != Value::TypeString) return true;
  return static_cast<std::string>(*uri) == ownServiceUri();
}

std::optional<UrisByTopic> connectedPublishers() {
  Value arguments;
  arguments[0] = ros::this_node::getName();
  std::optional<Value> connections = askSlaveApi("getBusInfo", arguments);
  if (!connections || connections->getType() != Value::TypeArray) return std::nullopt;
  UrisByTopic uris;
  for (Value& connection : elements(*connections)) {
    // [id, URI of the other node, direction, transport, topic, ...]
    const bool inbound = static_cast<std::string>(connection[2]) == "i";
    if (inbound) uris[static_cast<std::string>(connection[4])].insert(static_cast<std::string>(connection[1]));
  }
  return uris;
}

bool registerSubscriber(const std::string& topic, const std::optional<UrisByTopic>& connected) {
  std::optional<Value> publishers = askMasterApi("registerSubscriber", topic, "*");
  if (!publishers) return false;
  if (!connected) return true;
  std::set<std::string> uris = urisOf(*connected, topic);
  if (publishers->getType() == Value::TypeArray) {
    for (Value& uri : elements(*publishers)) uris.insert(static_cast<std::string>(uri));
  }
  uris.erase(ownUri());
  return uris.empty() || updatePublishers(topic, uris);
}

}  // namespace frontier_pilot
