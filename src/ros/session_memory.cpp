#include <ros/master.h>
#include <ros/param.h>
#include <ros/this_node.h>
#include <unistd.h>
#include <xmlrpcpp/XmlRpcValue.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <system_error>
#include <utility>

#include "frontier_pilot/core/files.h"
#include "frontier_pilot/core/text.h"
#include "frontier_pilot/ros/session_memory.h"

namespace frontier_pilot {
namespace {

constexpr std::size_t kLongestText = 65536;  // [bytes]

std::string asFileName(std::string name) {
  std::replace(name.begin(), name.end(), '/', '.');
  return name;
}

namespace fs = std::filesystem;

constexpr std::chrono::seconds kRestart(10);  // for a node that is started again
const fs::file_time_type g_process_began = fs::file_time_type::clock::now();

/// A process that writes such files, and the one that started it: a roslaunch starts what has died again.
struct Writer {
  int process = 0;
  int parent = 0;
};

/// Who wrote `file`, as its second line says; zeros if that cannot be read.
Writer writerOf(const fs::path& file) {
  std::istringstream content(readFile(file, kLongestText).bytes);
  std::string text;
  Writer writer;
  if (std::getline(content, text)) content >> writer.process >> writer.parent;
  return writer;
}

/// Whether this process was started in the place of `writer`, which is gone.
bool replaces(const Writer& writer) {
  return writer.process > 0 && writer.parent == getppid() && kill(writer.process, 0) != 0 && errno == ESRCH;
}

/// Gives what went wrong, or an empty text.
std::string removeAll(const std::vector<fs::path>& files) {
  std::string problem;
  for (const fs::path& file : files) {
    std::error_code error;
    fs::remove(file, error);
    if (error) problem = error.message();
  }
  return problem;
}

/// Files of this name in other sessions whose writer died just before this process was started in its place.
std::vector<fs::path> leftBehind(const fs::path& sessions, const std::string& name, const std::vector<fs::path>& own) {
  std::vector<fs::path> found;
  std::error_code error;
  for (const auto& session : fs::directory_iterator(sessions, error)) {
    const fs::path file = session.path() / name;
    std::error_code missing;
    const auto written = fs::last_write_time(file, missing);
    if (missing || written < g_process_began - kRestart) continue;
    if (std::find(own.begin(), own.end(), file) == own.end() && replaces(writerOf(file))) found.push_back(file);
  }
  return found;
}

}  // namespace

SessionMemory::SessionMemory(const std::filesystem::path& ros_home, const std::vector<std::string>& sessions,
                             std::string what, std::string node)
    : ros_home_(ros_home), name_(std::move(what) + asFileName(std::move(node))) {
  enter(sessions);
  elsewhere_ = leftBehind(ros_home_ / "frontier_pilot", name_, files_);
}

bool SessionMemory::enter(const std::vector<std::string>& sessions) {
  const std::vector<std::filesystem::path> before = std::exchange(files_, {});
  for (const std::string& session : sessions) {
    files_.push_back(ros_home_ / "frontier_pilot" / asFileName(session) / name_);
  }
  if (files_ == before) return false;
  elsewhere_ = before;
  return true;
}

std::optional<fs::path> SessionMemory::find() const {
  for (const auto& files : {files_, elsewhere_}) {
    for (const fs::path& file : files) {
      std::error_code error;
      if (fs::symlink_status(file, error).type() != fs::file_type::not_found) return file;
    }
  }
  return std::nullopt;
}

std::optional<std::string> SessionMemory::recall() const {
  const std::optional<fs::path> file = find();
  if (!file) return std::nullopt;
  // Whatever is there was put there by a stop, even if it cannot be read.
  const std::string text = readFile(*file, kLongestText).bytes;
  return printable(text.substr(0, text.find('\n')), kLongestText);
}

std::string SessionMemory::remember(const std::string& text) const {
  const std::string content = text + "\n" + std::to_string(getpid()) + " " + std::to_string(getppid()) + "\n";
  std::string problem;
  for (const fs::path& file : files_) {
    std::error_code error;
    fs::create_directories(file.parent_path(), error);
    // It has to survive this process and not the machine: a new master starts free, and the zeros must not wait for a
    // disk.
    const std::string why = error ? error.message() : writeFile(file, content, Survives::kProcessDeath);
    if (!why.empty()) problem = "cannot write " + file.string() + ": " + why;
  }
  if (problem.empty()) removeAll(elsewhere_);
  return problem;
}

std::string SessionMemory::forget() const {
  const std::string problem = removeAll(elsewhere_);
  const std::string own = removeAll(files_);
  return own.empty() ? problem : own;
}

void SessionMemory::endInOrder() const {
  std::error_code ignored;
  for (const fs::path& file : files_) fs::last_write_time(file, fs::file_time_type::min(), ignored);
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
