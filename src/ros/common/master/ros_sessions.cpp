#include "ros/common/master/ros_sessions.h"

#include <ros/this_node.h>
#include <xmlrpcpp/XmlRpcValue.h>

#include <cstdint>
#include <fstream>
#include <optional>

#include "ros/common/master/xml_rpc.h"
#include "ros/common/memory/process_identity.h"

namespace frontier_pilot {

std::string nameOfMaster(int process) {
  std::string command;
  std::getline(std::ifstream("/proc/" + std::to_string(process) + "/cmdline"), command);
  const std::uint64_t began = command.find("rosmaster") == std::string::npos ? 0 : beginOf(process);
  if (began == 0) return {};
  // Process ids are used again, and start again after a reboot.
  return "master-" + std::to_string(process) + "-" + std::to_string(began) + "-" + bootId();
}

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
  const std::string master = process ? nameOfMaster(*process) : std::string();
  if (!master.empty()) sessions.push_back(master);
  return sessions;
}

}  // namespace frontier_pilot
