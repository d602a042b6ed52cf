#include "ros/common/master/topic_list.h"

#include <ros/this_node.h>
#include <xmlrpcpp/XmlRpcException.h>

#include "ros/common/master/xml_rpc.h"

namespace frontier_pilot {
namespace {

std::vector<std::string> othersOf(const std::vector<std::string>& nodes) {
  std::vector<std::string> others;
  for (const std::string& node : nodes) {
    if (node != ros::this_node::getName()) others.push_back(node);
  }
  return others;
}

}  // namespace

std::optional<std::map<std::string, std::string>> askTopicTypes() {
  XmlRpc::XmlRpcValue request;
  request[0] = ros::this_node::getName();
  try {
    std::optional<XmlRpc::XmlRpcValue> answer = requestFromMaster("getTopicTypes", request);
    if (!answer) return std::nullopt;
    std::map<std::string, std::string> types;
    for (XmlRpc::XmlRpcValue& entry : elements(*answer))
      types[static_cast<std::string>(entry[0])] = static_cast<std::string>(entry[1]);
    return types;
  } catch (const XmlRpc::XmlRpcException&) {
    return std::nullopt;
  }
}

std::vector<robot_check::Topic> listTopics(const MasterState& state, const std::map<std::string, std::string>& types) {
  std::map<std::string, robot_check::Topic> topics;
  for (const auto& [name, nodes] : state.publishers) topics[name].publishers = othersOf(nodes);
  for (const auto& [name, nodes] : state.subscribers) topics[name].subscribers = othersOf(nodes);
  std::vector<robot_check::Topic> list;
  for (auto& [name, topic] : topics) {
    topic.name = name;
    const auto type = types.find(name);
    if (type != types.end()) topic.type = type->second;
    list.push_back(std::move(topic));
  }
  return list;
}

}  // namespace frontier_pilot
