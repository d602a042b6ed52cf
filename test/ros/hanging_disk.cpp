// A disk that hangs, for a process that has this library preloaded (LD_PRELOAD): open, open64, opendir, mkdir and
// remove of a path below the folder HANGING_DISK wait as long as there is a file HANGING_DISK.hangs.
#include <dirent.h>
#include <dlfcn.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <string>

namespace {

void waitForDisk(const std::string& path) {
  const char* disk = std::getenv("HANGING_DISK");
  if (disk == nullptr || path.rfind(disk, 0) != 0) return;
  const std::string sign = std::string(disk) + ".hangs";
  while (access(sign.c_str(), F_OK) == 0) usleep(10'000);
}

/// The function of that name which this library hides.
template <typename Function>
Function* hidden(const char* name) {
  return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

int openFile(const char* name, const char* path, int flags, va_list rest) {
  const mode_t mode = (flags & O_CREAT) != 0 ? va_arg(rest, mode_t) : 0;
  waitForDisk(path);
  return hidden<int(const char*, int, ...)>(name)(path, flags, mode);
}

}  // namespace

extern "C" {

int open(const char* path, int flags, ...) {
  va_list rest;
  va_start(rest, flags);
  const int file = openFile("open", path, flags, rest);
  va_end(rest);
  return file;
}

int open64(const char* path, int flags, ...) {
  va_list rest;
  va_start(rest, flags);
  const int file = openFile("open64", path, flags, rest);
  va_end(rest);
  return file;
}

DIR* opendir(const char* path) {
  waitForDisk(path);
  return hidden<DIR*(const char*)>("opendir")(path);
}

int mkdir(const char* path, mode_t mode) noexcept {
  waitForDisk(path);
  return hidden<int(const char*, mode_t)>("mkdir")(path, mode);
}

int remove(const char* path) noexcept {
  waitForDisk(path);
  return hidden<int(const char*)>("remove")(path);
}

}  // extern "C"
