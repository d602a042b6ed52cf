#include "ros/common/messages/robot_speakers.h"

#include <iterator>

namespace frontier_pilot {
namespace {

constexpr std::size_t kMostSpeakers = 100;  ///< of robots; nobody speaks for more than that
constexpr Duration kSpeakerSilent = std::chrono::seconds(10);

bool isSilent(SteadyTime then, SteadyTime now) { return now - then > kSpeakerSilent; }

/// Whether `node` is /robot/..., or /some/where/robot/...
bool isInNamespaceOf(const std::string& node, const std::string& robot) {
  return node.find('/' + robot + '/') != std::string::npos;
}

}  // namespace

std::string RobotSpeakers::insteadOf(const std::string& node, const std::string& robot, SteadyTime now) const {
  const auto found = speakers_.find(robot);
  if (found == speakers_.end() || found->second.node == node || isSilent(found->second.at, now)) return {};
  const bool is_nearer = isInNamespaceOf(node, robot) && !isInNamespaceOf(found->second.node, robot);
  return is_nearer ? std::string() : found->second.node;
}

void RobotSpeakers::heard(const std::string& node, const std::string& robot, SteadyTime now) {
  const auto found = speakers_.find(robot);
  if (found != speakers_.end()) {
    found->second = {node, now};
    return;
  }
  for (auto entry = speakers_.begin(); entry != speakers_.end();)
    entry = isSilent(entry->second.at, now) ? speakers_.erase(entry) : std::next(entry);
  if (speakers_.size() < kMostSpeakers) speakers_[robot] = {node, now};
}

}  // namespace frontier_pilot
