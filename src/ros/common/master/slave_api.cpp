#include "ros/common/master/slave_api.h"

#include <ros/console.h>
#include <ros/init.h>
#include <ros/network.h>
#include <ros/this_node.h>
#include <ros/topic_manager.h>
#include <ros/xmlrpc_manager.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <string>

#include "ros/common/master/registration.h"
#include "ros/common/master/xml_rpc.h"

namespace frontier_pilot {
namespace {

using Value = XmlRpc::XmlRpcValue;

std::atomic<bool> g_replaced{false};  ///< set on roscpp's thread

void refuse(Value& result, const std::string& why) {
  result[0] = 0;
  result[1] = why;
  result[2] = 0;
}

void refuseMulticall(Value& /*arguments*/, Value& result) { refuse(result, "system.multicall is not offered"); }

bool offersTcp(Value& protocols) {
  for (Value& protocol : elements(protocols)) {
    if (static_cast<std::string>(protocol[0]) == "TCPROS") return true;
  }
  return false;
}

/// `arguments` are the caller's name, the topic, and the protocols that it can use, each with its own arguments. A
/// wrong type throws an XmlRpcException, which XmlRpc++ answers with a fault.
void requestTopic(Value& arguments, Value& result) {
  const std::string topic = arguments[1];
  if (!ros::TopicManager::instance()->lookupPublication(topic)) return refuse(result, topic + " is not published here");
  if (!offersTcp(arguments[2])) return refuse(result, "only TCPROS is offered");
  result[0] = 1;
  result[1] = std::string();
  result[2][0] = std::string("TCPROS");
  result[2][1] = ros::network::getHost();
  result[2][2] = static_cast<int>(tcpPort());
}

/// The master says why as "[/NODE] Reason: ...", and calls the address that it has for this node. If that process was
/// killed, another one may have its port by now.
bool isMeantForAnotherNode(const std::string& reason) {
  const std::size_t end = reason.find("] Reason: ");
  return end != std::string::npos && reason.substr(0, end) != "[" + ros::this_node::getName();
}

/// `arguments` are the caller's name and why this node is to end, which roscpp only logs. The node ends as it does on a
/// signal, with its last words: roscpp's own shutdown closes the publishers first. The signal is sent to the process,
/// because roscpp's thread, which runs this, takes none.
void shutDown(Value& arguments, Value& result) {
  if (arguments.getType() != Value::TypeArray || arguments.size() < 2) return refuse(result, "no reason is given");
  const std::string reason = arguments[1];
  if (isMeantForAnotherNode(reason)) return refuse(result, "this is " + ros::this_node::getName());
  ROS_WARN_STREAM("ROS shuts this node down: " << reason);
  if (reason.find("new node registered with same name") != std::string::npos) g_replaced = true;
  kill(getpid(), SIGTERM);
  result[0] = 1;
  result[1] = std::string();
  result[2] = 0;
}

}  // namespace

bool isReplaced() { return g_replaced; }

void replaceHarmfulMethods() {
  const ros::XMLRPCManagerPtr& api = ros::XMLRPCManager::instance();
  // First: unlike bind, unbind asks roscpp's thread for the lock, which that holds nearly always.
  api->unbind("requestTopic");
  api->bind("requestTopic", requestTopic);
  api->unbind("shutdown");
  api->bind("shutdown", shutDown);
  api->bind("system.multicall", refuseMulticall);
}

}  // namespace frontier_pilot
