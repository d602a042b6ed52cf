#include "ros/common/logging/console_output.h"

#include <fcntl.h>
#include <ros/console.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <string>

namespace frontier_pilot {

void nameNodeInLines(const std::string& node) {
  std::setvbuf(stdout, nullptr, _IOLBF, BUFSIZ);
  ros::console::setFixedFilterToken("node", node);
  if (std::getenv("ROSCONSOLE_FORMAT") != nullptr) return;
  // The log has read its environment before main().
  ros::console::g_formatter.tokens_.clear();
  ros::console::g_formatter.init("[${severity}] [${time}] [${node}]: ${message}");
}

bool dropUnreadOutput(int descriptor) {
  struct stat status {};
  if (fstat(descriptor, &status) != 0) return false;
  if (!S_ISFIFO(status.st_mode) && isatty(descriptor) == 0) return false;
  // Opened anew, because the flag O_NONBLOCK belongs to what processes share when they inherit a descriptor.
  const std::string path = "/proc/self/fd/" + std::to_string(descriptor);
  const int own = ::open(path.c_str(), O_WRONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC);
  if (own < 0) return false;  // the terminal of another user, or nobody can read any more
  const bool replaced = dup2(own, descriptor) == descriptor;
  ::close(own);
  return replaced;
}

void dropUnreadOutput() {
  dropUnreadOutput(STDOUT_FILENO);
  dropUnreadOutput(STDERR_FILENO);
}

}  // namespace frontier_pilot
