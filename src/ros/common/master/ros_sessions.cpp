#include "ros/common/master/ros_sessions.h"

#include <ros/master.h>
#include <ros/param.h>
#include <ros/this_node.h>
#include <xmlrpcpp/XmlRpcValue.h>

#include <fstream>

namespace frontier_pilot {

std::vector<std::string> rosSessions() {
  std::vector<std::string> sessions;
  std::string run_id;
  if (ros::param::get("/run_id", run_id) && !run_id.empty()) sessions.push_back(run_id);
  XmlRpc::XmlRpcValue request, response, pid;
  request[0] = ros::this_node::getName();
  if (!ros::master::execute("getPid", request, response, pid, true)) return sessions;
  // Process ids start again after a reboot, so the boot id is part of the name.
  std::string boot;
  std::getline(std::ifstream("/proc/sys/kernel/random/boot_id"), boot);
  sessions.push_back("master-" + std::to_string(static_cast<int>(pid)) + "-" + boot);
  return sessions;
}

}  // namespace frontier_pilot
