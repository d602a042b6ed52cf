#pragma once

#include <filesystem>

#include "frontier_pilot/core/time.h"

namespace frontier_pilot::map_files {

/// Excludes other calls of saveMap and loadMap in a folder as long as this object lives: two programs, or threads, that
/// save under one name at the same moment would leave files of both. It is an advisory lock of the folder (flock(2)),
/// which leaves no file behind, and which ends with the process. On a file system without such locks nothing is
/// excluded.
class FolderLock {
 public:
  enum class Kind {
    kRead,   ///< several at a time
    kWrite,  ///< one, and no kRead
  };

  /// Waits for the lock for at most `patience`, and goes on without it if another one still has it then.
  FolderLock(const std::filesystem::path& folder, Kind kind, Duration patience);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

  /// Whether another one still had the lock.
  bool isTaken() const { return taken_; }

 private:
  int folder_;
  bool taken_ = false;
};

}  // namespace frontier_pilot::map_files
