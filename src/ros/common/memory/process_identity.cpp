#include "ros/common/memory/process_identity.h"

#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <sstream>
#include <vector>

namespace frontier_pilot {

std::uint64_t beginOf(int process) {
  std::string stat;
  std::getline(std::ifstream("/proc/" + std::to_string(process) + "/stat"), stat);
  // Field 3 is the state and field 22 the start time; field 2 may contain any character and ends with the last ')'.
  std::istringstream fields(stat.substr(std::min(stat.size(), stat.rfind(')') + 1)));
  std::vector<std::string> words{std::istream_iterator<std::string>(fields), {}};
  if (words.size() < 20 || words.front() == "Z" || words.front() == "X") return 0;
  return std::strtoull(words[19].c_str(), nullptr, 10);
}

std::string bootId() {
  static const std::string boot = [] {
    std::string line;
    std::getline(std::ifstream("/proc/sys/kernel/random/boot_id"), line);
    return line;
  }();
  return boot;
}

ProcessIdentity ProcessIdentity::own() {
  return {getpid(), getppid(), beginOf(getpid()), beginOf(getppid()), bootId()};
}

bool ProcessIdentity::lives() const { return began != 0 && beginOf(process) == began; }

bool ProcessIdentity::isReplacedByThisOne() const {
  const ProcessIdentity self = own();
  const bool same_parent = parent == self.parent && self.parent_began != 0 && parent_began == self.parent_began;
  return process > 0 && same_parent && boot == self.boot && !lives();
}

std::ostream& operator<<(std::ostream& stream, const ProcessIdentity& identity) {
  return stream << identity.process << ' ' << identity.parent << ' ' << identity.began << ' ' << identity.parent_began
                << ' ' << identity.boot << '\n';
}

std::istream& operator>>(std::istream& stream, ProcessIdentity& identity) {
  return stream >> identity.process >> identity.parent >> identity.began >> identity.parent_began >> identity.boot;
}

}  // namespace frontier_pilot
