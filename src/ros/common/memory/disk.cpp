#include "ros/common/memory/disk.h"

#include <sys/stat.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <deque>
#include <mutex>
#include <system_error>

namespace frontier_pilot {

namespace fs = std::filesystem;

namespace {

std::mutex g_mutex;
Duration g_patience = std::chrono::milliseconds(50);
pid_t g_owner = 0;  // of the latest thread

/// All that were begun, as long as the process lives: one may hang, and others may use it.
std::deque<PatientThread>& threads() {
  static auto& all = *new std::deque<PatientThread>;
  return all;
}

}  // namespace

PatientThread& diskThread() {
  const std::lock_guard<std::mutex> lock(g_mutex);
  if (g_owner != getpid()) threads().emplace_back(g_patience);
  g_owner = getpid();
  return threads().back();
}

void setDiskPatience(Duration patience) {
  const std::lock_guard<std::mutex> lock(g_mutex);
  g_patience = patience;
  g_owner = 0;  // the next job begins a thread
}

std::string onDisk(const std::function<std::string()>& job) {
  return diskThread().run<std::string>(job).value_or(kSilentDisk);
}

std::vector<fs::path> entriesOf(const fs::path& folder) {
  std::vector<fs::path> entries;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
    entries.push_back(entry->path());
  }
  return entries;
}

fs::path rosHome() {
  if (const char* ros_home = std::getenv("ROS_HOME")) return ros_home;
  const char* home = std::getenv("HOME");
  return fs::path(home != nullptr ? home : "/") / ".ros";
}

fs::path spareFolder() {
  if (const char* runtime = std::getenv("XDG_RUNTIME_DIR")) return runtime;
  const fs::path folder = "/dev/shm/frontier_pilot-" + std::to_string(getuid());
  mkdir(folder.c_str(), S_IRWXU);
  struct stat status {};
  const bool ours = lstat(folder.c_str(), &status) == 0 && S_ISDIR(status.st_mode) && status.st_uid == getuid() &&
                    (status.st_mode & (S_IWGRP | S_IWOTH)) == 0;
  return ours ? folder : fs::path();
}

}  // namespace frontier_pilot
