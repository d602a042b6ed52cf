#include "ros/common/master/ros_sessions.h"

#include <ros/this_node.h>
#include <xmlrpcpp/XmlRpcValue.h>

#include <fstream>
#include <optional>

#include "ros/common/master/xml_rpc.h"
#include "ros/common/memory/process_identity.h"

namespace frontier_pilot {
namespace {

/// When the master was started, as a part of a name; empty if it runs on another computer, or is called otherwise.
std::string beginOfMaster(int process) {
  std::string command;
  std::getline(std::ifstream("/proc/" + std::to_string(process) + "/cmdline"), command);
  return command.find("rosmaster") == std::string::npos ? "" : std::to_string(beginOf(process)) + "-";
}

}  // namespace

std::vector<std::string> rosSessions() {
  std::vector<std::string> sessions;
  XmlRpc::XmlRpcValue request;
  request[0] = ros::this_node::getName();
  const std::optional<int> process = pidOfMaster();
  request[1] = "/run_id";
  std::optional<XmlRpc::XmlRpcValue> run_id = requestFromMaster("getParam", request);
  if (run_id && run_id->getType() == XmlRpc::XmlRpcValue::TypeString && !static_cast<std::string>(*run_id).empty()) {
    sessions.push_back(*run_id);
  }
  if (!process) return sessions;
  // Process ids are used again, and start again after a reboot.
  sessions.push_back("master-" + std::to_string(*process) + "-" + beginOfMaster(*process) + bootId());
  return sessions;
}

}  // namespace frontier_pilot
