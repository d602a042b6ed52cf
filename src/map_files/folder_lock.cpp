#include "map_files/folder_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <thread>

namespace frontier_pilot::map_files {

FolderLock::FolderLock(const std::filesystem::path& folder, Kind kind, Duration patience)
    : folder_(open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
  constexpr Duration kPause = std::chrono::milliseconds(10);
  const int operation = (kind == Kind::kRead ? LOCK_SH : LOCK_EX) | LOCK_NB;
  for (Duration waited{}; folder_ >= 0 && flock(folder_, operation) != 0 && errno == EWOULDBLOCK; waited += kPause) {
    taken_ = waited >= patience;
    if (taken_) return;
    std::this_thread::sleep_for(kPause);
  }
}

FolderLock::~FolderLock() {
  if (folder_ >= 0) close(folder_);
}

}  // namespace frontier_pilot::map_files
