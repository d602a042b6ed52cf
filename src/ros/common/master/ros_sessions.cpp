#include "ros/common/master/ros_sessions.h"

#include <ros/master.h>
#include <ros/param.h>
#include <ros/this_node.h>
#include <xmlrpcpp/XmlRpcValue.h>

#include <fstream>

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
  std::string run_id;
  if (ros::param::get("/run_id", run_id) && !run_id.empty()) sessions.push_back(run_id);
  XmlRpc::XmlRpcValue request, response, pid;
  request[0] = ros::this_node::getName();
  if (!ros::master::execute("getPid", request, response, pid, true)) return sessions;
  // Process ids are used again, and start again after a reboot.
  const int process = pid;
  sessions.push_back("master-" + std::to_string(process) + "-" + beginOfMaster(process) + bootId());
  return sessions;
}

}  // namespace frontier_pilot
