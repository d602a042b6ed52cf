#include "ros/common/master/local_name.h"

#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <cstdlib>
#include <fstream>
#include <functional>

namespace frontier_pilot {
namespace {

/// A socket with that name; -1 if there is none, and the reason is in `errno`.
int boundTo(const std::string& name) {
  const int fresh = socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
  if (fresh < 0) return fresh;
  sockaddr_un address{};
  address.sun_family = AF_UNIX;  // a name that begins with a zero byte is that of no file
  std::copy(name.begin(), name.end(), address.sun_path + 1);
  const auto length = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + 1 + name.size());
  if (bind(fresh, reinterpret_cast<const sockaddr*>(&address), length) == 0) return fresh;
  const int reason = errno;
  close(fresh);
  errno = reason;
  return -1;
}

}  // namespace

// Hashed, because an address of a socket has room for 107 characters, and names of nodes may be longer.
LocalName::LocalName(const std::string& name)
    : name_("frontier_pilot." + std::to_string(std::hash<std::string>()(name))) {}

LocalName::~LocalName() {
  for (const int socket : sockets_) {
    if (socket >= 0) close(socket);
  }
}

bool LocalName::take() {
  if (sockets_[0] >= 0) return true;
  sockets_[0] = boundTo(name_);
  if (sockets_[0] < 0) return errno != EADDRINUSE;
  sockets_[1] = boundTo(name_ + '.' + std::to_string(getpid()));
  return true;
}

int LocalName::owner() const {
  std::ifstream sockets("/proc/net/unix");
  const std::string wanted = '@' + name_ + '.';
  for (std::string line; std::getline(sockets, line);) {
    const std::size_t at = line.find(wanted);
    if (at != std::string::npos) return std::atoi(line.c_str() + at + wanted.size());
  }
  return 0;
}

}  // namespace frontier_pilot
