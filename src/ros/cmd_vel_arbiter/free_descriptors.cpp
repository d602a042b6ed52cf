#include "ros/cmd_vel_arbiter/free_descriptors.h"

#include <sys/eventfd.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <system_error>

namespace frontier_pilot {
namespace {

/// Several callers may connect between two looks, and each needs a descriptor.
constexpr std::size_t kReserve = 8;

}  // namespace

std::string whyNoCallerCanConnect() {
  // Only the attempt to open something tells the limits of the process from those of the computer.
  std::array<int, kReserve> opened{};
  std::size_t count = 0;
  int error = 0;
  while (count < kReserve && error == 0) {
    opened[count] = eventfd(0, EFD_CLOEXEC);
    opened[count] >= 0 ? ++count : error = errno;
  }
  for (std::size_t i = 0; i < count; ++i) ::close(opened[i]);
  if (error == 0) return {};
  return "this node can open no more connections (" + std::system_category().message(error) + ")";
}

}  // namespace frontier_pilot
