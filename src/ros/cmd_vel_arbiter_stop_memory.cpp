#include <ros/master.h>
#include <ros/param.h>
#include <ros/this_node.h>
#include <xmlrpcpp/XmlRpcValue.h>

#include <algorithm>
#include <cstdlib>
#include <system_error>

#include "frontier_pilot/core/files.h"
#include "frontier_pilot/ros/stop_memory.h"

namespace frontier_pilot {
namespace {

constexpr std::size_t kLongestCause = 65536;  // [bytes]

std::string asFileName(std::string name) {
  std::replace(name.begin(), name.end(), '/', '.');
  return name;
}

}  // namespace

StopMemory::StopMemory(const std::filesystem::path& ros_home, const std::string& session, const std::string& node)
    : ros_home_(ros_home), node_(node) {
  enter(session);
}

bool StopMemory::enter(const std::string& session) {
  const std::filesystem::path before = file_;
  file_ = ros_home_ / "frontier_pilot" / asFileName(session) / ("stopped" + asFileName(node_));
  return file_ != before;
}

std::optional<std::string> StopMemory::recall() const {
  std::error_code error;
  if (std::filesystem::symlink_status(file_, error).type() == std::filesystem::file_type::not_found)
    return std::nullopt;
  // Whatever else is there is a stop all the same, even if it cannot be read.
  const std::string cause = readFile(file_, kLongestCause).bytes;
  return cause.substr(0, cause.find('\n'));
}

std::string StopMemory::remember(const std::string& cause) const {
  std::error_code error;
  std::filesystem::create_directories(file_.parent_path(), error);
  if (error) return error.message();
  // It has to survive this process and not the machine: a new master starts free, and the zeros must not wait for a
  // disk.
  const std::string problem = writeFile(file_, cause + "\n", Survives::kProcessDeath);
  return problem.empty() ? std::string() : "cannot write " + file_.string() + ": " + problem;
}

std::string StopMemory::forget() const {
  std::error_code error;
  std::filesystem::remove(file_, error);
  return error ? error.message() : std::string();
}

std::filesystem::path rosHome() {
  if (const char* ros_home = std::getenv("ROS_HOME")) return ros_home;
  const char* home = std::getenv("HOME");
  return std::filesystem::path(home != nullptr ? home : "/") / ".ros";
}

std::string rosSession() {
  std::string run_id;
  if (ros::param::get("/run_id", run_id) && !run_id.empty()) return run_id;
  XmlRpc::XmlRpcValue request, response, pid;
  request[0] = ros::this_node::getName();
  if (!ros::master::execute("getPid", request, response, pid, true)) return "unknown";
  return "master-" + std::to_string(static_cast<int>(pid));
}

}  // namespace frontier_pilot
