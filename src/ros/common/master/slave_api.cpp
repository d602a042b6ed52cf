#include "ros/common/master/slave_api.h"

#include <ros/network.h>
#include <ros/topic_manager.h>
#include <ros/xmlrpc_manager.h>

#include <string>

#include "ros/common/master/registration.h"
#include "ros/common/master/xml_rpc.h"

namespace frontier_pilot {
namespace {

using Value = XmlRpc::XmlRpcValue;

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

}  // namespace

void replaceHarmfulMethods() {
  const ros::XMLRPCManagerPtr& api = ros::XMLRPCManager::instance();
  api->unbind(
      "requestTopic");  // first: unlike bind, it asks roscpp's thread for the lock, which that holds nearly always
  api->bind("requestTopic", requestTopic);
  api->bind("system.multicall", refuseMulticall);
}

}  // namespace frontier_pilot
