#include "ros/common/master/lost_connections.h"

#include <ros/this_node.h>

#include <algorithm>
#include <set>
#include <utility>

#include "ros/common/clock.h"
#include "ros/common/throttled_log.h"

namespace frontier_pilot {
namespace {

constexpr Duration kTimeToConnect = std::chrono::seconds(2);
constexpr Duration kFirstPause = std::chrono::seconds(10);
constexpr Duration kLongestPause = std::chrono::minutes(5);

/// Addresses of nodes. The one that was known in the last look is tried first, so that the master is asked only about
/// new and lost nodes, and about each at most once.
class AddressBook {
 public:
  explicit AddressBook(std::map<std::string, std::string> known) : known_(std::move(known)) {}

  /// Whether one of `connected` is the node's address.
  bool has(const std::set<std::string>& connected, const std::string& node) {
    const auto [entry, first] = used_.try_emplace(node, known_[node]);
    if (first && connected.count(entry->second) == 0) entry->second = uriOf(node);
    return connected.count(entry->second) > 0;
  }

  /// The addresses that were used since the construction.
  const std::map<std::string, std::string>& used() const { return used_; }

 private:
  std::map<std::string, std::string> known_, used_;
};

}  // namespace

std::vector<std::string> ReconnectTimes::due(const std::vector<std::string>& lost, SteadyTime now) {
  std::map<std::string, Attempt> attempts;
  std::vector<std::string> topics;
  for (const std::string& topic : lost) {
    const auto before = attempts_.find(topic);
    Attempt attempt = before == attempts_.end() ? Attempt{now + kTimeToConnect, kFirstPause} : before->second;
    if (now >= attempt.next) {
      topics.push_back(topic);
      attempt = {now + attempt.pause, std::min(2 * attempt.pause, kLongestPause)};
    }
    attempts[topic] = attempt;
  }
  attempts_ = std::move(attempts);
  return topics;
}

NodesByName LostConnections::findLost(const MasterState& state, const std::vector<std::string>& subscribed,
                                      const UrisByTopic& connected) {
  AddressBook addresses(uris_);
  NodesByName lost;
  for (const std::string& topic : subscribed) {
    const std::set<std::string> uris = urisOf(connected, topic);
    for (const std::string& node : nodesOf(state.publishers, topic)) {
      if (node != ros::this_node::getName() && !addresses.has(uris, node)) lost[topic].push_back(node);
    }
  }
  uris_ = addresses.used();
  return lost;
}

void LostConnections::mend(const MasterState& state, const std::vector<std::string>& subscribed,
                           const UrisByTopic& connected) {
  const NodesByName lost = findLost(state, subscribed, connected);
  std::vector<std::string> topics;
  for (const auto& [topic, publishers] : lost) topics.push_back(topic);
  for (const std::string& topic : times_.due(topics, steadyNow())) {
    const std::string publisher = firstLiving(nodesOf(lost, topic));
    if (publisher.empty()) continue;
    THROTTLED_WARN(publisher << " publishes " << topic << ", but this node is not connected to it: connects again");
    registerSubscriber(topic, connected);
  }
}

}  // namespace frontier_pilot
