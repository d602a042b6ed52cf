#include "ros/common/master/local_name.h"

#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <cstdint>

namespace frontier_pilot {
namespace {

/// FNV-1a: an address of a socket has room for 107 characters, and names of nodes may be longer.
std::uint64_t hashOf(const std::string& name) {
  std::uint64_t hash = 14695981039346656037ULL;
  for (const char c : name) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211ULL;
  return hash;
}

/// Calls `use(address, length)` as the functions of sockets want an address.
template <class Use>
int withAddress(const std::string& name, Use use) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  std::copy(name.begin(), name.end(), std::begin(address.sun_path));
  const auto length = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + name.size());
  return use(reinterpret_cast<const sockaddr*>(&address), length);
}

int newSocket() { return socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0); }

}  // namespace

LocalName::LocalName(const std::string& name)
    : address_(std::string(1, '\0') + "frontier_pilot." + std::to_string(hashOf(name))) {}

LocalName::~LocalName() {
  if (socket_ >= 0) close(socket_);
}

bool LocalName::take() {
  if (socket_ >= 0) return true;
  const int fresh = newSocket();
  if (fresh < 0) return true;
  const int bound = withAddress(
      address_, [fresh](const sockaddr* address, socklen_t length) { return bind(fresh, address, length); });
  if (bound != 0) {
    const bool is_taken = errno == EADDRINUSE;
    close(fresh);
    return !is_taken;
  }
  listen(fresh, 1);  // only a socket that listens tells whose it is
  socket_ = fresh;
  return true;
}

int LocalName::owner() const {
  const int probe = newSocket();
  if (probe < 0) return 0;
  ucred credentials{};
  socklen_t size = sizeof credentials;
  const int connected = withAddress(
      address_, [probe](const sockaddr* address, socklen_t length) { return connect(probe, address, length); });
  const bool known = connected == 0 && getsockopt(probe, SOL_SOCKET, SO_PEERCRED, &credentials, &size) == 0;
  close(probe);
  return known ? credentials.pid : 0;
}

}  // namespace frontier_pilot
