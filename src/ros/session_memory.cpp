#include <ros/master.h>
#include <ros/param.h>
#include <ros/this_node.h>
#include <xmlrpcpp/XmlRpcValue.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <system_error>
#include <utility>

#include "frontier_pilot/core/files.h"
#include "frontier_pilot/ros/session_memory.h"

namespace frontier_pilot {
namespace {

constexpr std::size_t kLongestText = 65536;  // [bytes]

std::string asFileName(std::string name) {
  std::replace(name.begin(), name.end(), '/', '.');
  return name;
}

}  // namespace

SessionMemory::SessionMemory(const std::filesystem::path& ros_home, const std::vector<std::string>& sessions,
                             std::string what, std::string node)
    : ros_home_(ros_home), name_(std::move(what) + asFileName(std::move(node))) {
  enter(sessions);
}

bool SessionMemory::enter(const std::vector<std::string>& sessions) {
  const std::vector<std::filesystem::path> before = std::exchange(files_, {});
  for (const std::string& session : sessions) {
    files_.push_back(ros_home_ / "frontier_pilot" / asFileName(session) / name_);
  }
  return files_ != before;
}

std::optional<std::string> SessionMemory::recall() const {
  for (const std::filesystem::path& file : files_) {
    std::error_code error;
    if (std::filesystem::symlink_status(file, error).type() == std::filesystem::file_type::not_found) continue;
    // Whatever is there was put there by a stop, even if it cannot be read.
    const std::string text = readFile(file, kLongestText).bytes;
    return text.substr(0, text.find('\n'));
  }
  return std::nullopt;
}

std::string SessionMemory::remember(const std::string& text) const {
  std::string problem;
  for (const std::filesystem::path& file : files_) {
    std::error_code error;
    std::filesystem::create_directories(file.parent_path(), error);
    // It has to survive this process and not the machine: a new master starts free, and the zeros must not wait for a
    // disk.
    const std::string why = error ? error.message() : writeFile(file, text + "\n", Survives::kProcessDeath);
    if (!why.empty()) problem = "cannot write " + file.string() + ": " + why;
  }
  return problem;
}

std::string SessionMemory::forget() const {
  std::string problem;
  for (const std::filesystem::path& file : files_) {
    std::error_code error;
    std::filesystem::remove(file, error);
    if (error) problem = error.message();
  }
  return problem;
}

std::filesystem::path rosHome() {
  if (const char* ros_home = std::getenv("ROS_HOME")) return ros_home;
  const char* home = std::getenv("HOME");
  return std::filesystem::path(home != nullptr ? home : "/") / ".ros";
}

std::vector<std::string> rosSessions() {
  std::vector<std::string> sessions;
  std::string run_id;
  if (ros::param::get("/run_id", run_id) && !run_id.empty()) sessions.push_back(run_id);
  XmlRpc::XmlRpcValue request, response, pid;
  request[0] = ros::this_node::getName();
  if (!ros::master::execute("getPid", request, response, pid, true)) return sessions;
  // The numbers of processes begin anew when a machine does.
  std::string boot;
  std::getline(std::ifstream("/proc/sys/kernel/random/boot_id"), boot);
  sessions.push_back("master-" + std::to_string(static_cast<int>(pid)) + "-" + boot);
  return sessions;
}

}  // namespace frontier_pilot
