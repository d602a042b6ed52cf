#include "ros/common/launch_wait.h"

#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <string>
#include <thread>

#include "ros/common/memory/disk.h"

namespace frontier_pilot {
namespace {

using namespace std::chrono_literals;

constexpr auto kPoll = 100ms, kQuiet = 2000ms, kMost = 20000ms;

/// The process ids of what `process` has started and not ended.
std::set<std::string> childrenOf(int process) {
  std::set<std::string> children;
  for (const std::filesystem::path& thread : entriesOf("/proc/" + std::to_string(process) + "/task")) {
    std::ifstream list(thread / "children");
    children.insert(std::istream_iterator<std::string>(list), {});
  }
  return children;
}

}  // namespace

void waitForTheLaunch() {
  std::set<std::string> known = childrenOf(getppid());
  auto quiet = 0ms;
  for (auto waited = 0ms; quiet < kQuiet && waited < kMost; waited += kPoll, quiet += kPoll) {
    std::this_thread::sleep_for(kPoll);
    for (const std::string& child : childrenOf(getppid())) {
      if (known.insert(child).second) quiet = 0ms;
    }
  }
}

}  // namespace frontier_pilot
