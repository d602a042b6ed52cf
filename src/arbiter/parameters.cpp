#include "frontier_pilot/arbiter/parameters.h"

#include <algorithm>
#include <cctype>

namespace frontier_pilot::arbiter {
namespace {

SourceParameters builtIn(const char* name, int priority) {
  SourceParameters source;
  source.name = name;
  source.topic = std::string("cmd_vel_") + name;
  source.priority = priority;
  return source;
}

/// The name becomes part of a service name.
bool isPlainName(const std::string& name) {
  const auto plain = [](unsigned char c) { return std::isalnum(c) != 0 || c == '_'; };
  return !name.empty() && std::isalpha(static_cast<unsigned char>(name.front())) != 0 &&
         std::all_of(name.begin(), name.end(), plain);
}

void checkOne(const SourceParameters& source, const std::string& key, Problems& problems) {
  if (!isPlainName(source.name)) problems.push_back(key + "/name: must be a word of letters, digits and _");
  if (source.name == "obstacle_avoid" || source.name == "exploration") {
    problems.push_back(key + "/name: set_" + source.name + "_enabled is the service of another node");
  }
  if (source.topic.empty()) problems.push_back(key + "/topic: missing");
  if (source.topic == "cmd_vel" || source.topic == "/cmd_vel") {
    problems.push_back(key + "/topic: cmd_vel is what the arbiter itself publishes");
  }
}

void checkPair(const SourceParameters& a, const SourceParameters& b, const std::string& key, Problems& problems) {
  if (a.name == b.name) problems.push_back(key + "/name: there are two sources '" + a.name + "'");
  if (a.topic == b.topic) problems.push_back(key + "/topic: '" + a.topic + "' belongs to '" + a.name + "' already");
  if (a.priority == b.priority) {
    problems.push_back(key + "/priority: " + std::to_string(a.priority) + " is the priority of '" + a.name +
                       "' already");
  }
}

}  // namespace

std::vector<SourceParameters> builtInSources() {
  std::vector<SourceParameters> sources = {builtIn("avoid", 100), builtIn("behavior", 90), builtIn("patrol", 80),
                                           builtIn("nav", 60), builtIn("manual", 40)};
  sources.front().zero_means_idle = true;
  return sources;
}

void SourceParameters::startFromBuiltIn() {
  if (!topic.empty()) return;
  for (const SourceParameters& source : builtInSources()) {
    if (source.name == name) *this = source;
  }
}

void ArbiterParameters::check(Problems& problems) const {
  if (sources.empty()) problems.emplace_back("sources: there must be at least one");
  for (std::size_t i = 0; i < sources.size(); ++i) {
    const std::string key = "sources[" + std::to_string(i) + "]";
    checkOne(sources[i], key, problems);
    for (std::size_t j = 0; j < i; ++j) checkPair(sources[j], sources[i], key, problems);
  }
}

}  // namespace frontier_pilot::arbiter
