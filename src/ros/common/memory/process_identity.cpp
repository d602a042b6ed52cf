#include "ros/common/memory/process_identity.h"

#include <ros/master.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <sstream>
#include <vector>

namespace frontier_pilot {

namespace {

/// The fields of /proc/<process>/stat from the third one on, which is the state; none if there is no such process.
std::vector<std::string> statOf(int process) {
  std::string stat;
  std::getline(std::ifstream("/proc/" + std::to_string(process) + "/stat"), stat);
  // The second field may contain any character and ends with the last ')'.
  std::istringstream fields(stat.substr(std::min(stat.size(), stat.rfind(')') + 1)));
  return {std::istream_iterator<std::string>(fields), {}};
}

int parentOf(int process) {
  const std::vector<std::string> fields = statOf(process);
  return fields.size() < 2 ? 0 : std::atoi(fields[1].c_str());
}

bool isRoslaunch(int process) {
  std::string command;
  std::getline(std::ifstream("/proc/" + std::to_string(process) + "/cmdline"), command);
  return command.find("roslaunch") != command.npos || command.find("robots_launcher") != command.npos;
}

/// The nearest roslaunch above this process, or its parent if there is none.
int findStarter() {
  for (int above = getppid(); above > 0; above = parentOf(above)) {
    if (isRoslaunch(above)) return above;
  }
  return getppid();
}

/// Without spaces, and never empty.
std::string masterUri() {
  std::string uri = "-" + ros::master::getURI();
  uri.erase(std::remove_if(uri.begin(), uri.end(), [](unsigned char c) { return std::isspace(c) != 0; }), uri.end());
  return uri;
}

}  // namespace

std::uint64_t beginOf(int process) {
  constexpr std::size_t kState = 0, kStartTime = 19;
  const std::vector<std::string> fields = statOf(process);
  if (fields.size() <= kStartTime || fields[kState] == "Z" || fields[kState] == "X") return 0;
  return std::strtoull(fields[kStartTime].c_str(), nullptr, 10);
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
  const int by = findStarter();
  return {getpid(), by, beginOf(getpid()), beginOf(by), bootId(), masterUri()};
}

bool ProcessIdentity::lives() const { return began != 0 && beginOf(process) == began; }

bool ProcessIdentity::isReplacedByThisOne() const {
  const ProcessIdentity self = own();
  return isOfStarterOf(self) && boot == self.boot && master == self.master && !lives();
}

bool ProcessIdentity::isOfThisLaunch() const {
  const ProcessIdentity self = own();
  return process > 0 && boot == self.boot && (isOfStarterOf(self) || !isRoslaunch(self.starter));
}

bool ProcessIdentity::isOfStarterOf(const ProcessIdentity& other) const {
  return process > 0 && starter == other.starter && other.starter_began != 0 && starter_began == other.starter_began;
}

std::ostream& operator<<(std::ostream& stream, const ProcessIdentity& identity) {
  return stream << identity.process << ' ' << identity.starter << ' ' << identity.began << ' ' << identity.starter_began
                << ' ' << identity.boot << ' ' << identity.master << '\n';
}

std::istream& operator>>(std::istream& stream, ProcessIdentity& identity) {
  return stream >> identity.process >> identity.starter >> identity.began >> identity.starter_began >> identity.boot >>
         identity.master;
}

}  // namespace frontier_pilot
