#include "ros/common/master/lost_connections.h"

#include <ros/this_node.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <iterator>
#include <set>
#include <utility>

#include "ros/common/clock.h"
#include "ros/common/messages/latched_repeats.h"
#include "ros/common/throttled_log.h"

namespace frontier_pilot {
namespace {

constexpr Duration kTimeToConnect = std::chrono::seconds(2);
constexpr Duration kFirstPause = std::chrono::seconds(10);
constexpr Duration kLongestPause = std::chrono::minutes(5);

/// Addresses of nodes. Those of the last look are used again, so that the master is asked only about new and lost
/// nodes, about each at most once, and about nobody any more once it does not answer.
class AddressBook {
 public:
  explicit AddressBook(std::map<std::string, std::string> known) : known_(std::move(known)) {}

  /// Whether the node certainly has an address that is not one of `connected`.
  bool isMissingIn(const std::set<std::string>& connected, const std::string& node) {
    const auto [entry, first] = used_.try_emplace(node, known_[node]);
    if (first && connected.count(entry->second) == 0) entry->second = ask(node);
    return !entry->second.empty() && connected.count(entry->second) == 0;
  }

  /// The addresses that were used since the construction.
  const std::map<std::string, std::string>& used() const { return used_; }

 private:
  std::string ask(const std::string& node) {
    std::string uri = answers_ ? uriOf(node) : std::string();
    answers_ = !uri.empty();
    return uri;
  }

  std::map<std::string, std::string> known_, used_;
  bool answers_ = true;
};

/// One node is asked for anew in each look: it may have been restarted without a word of the master, and roscpp lists
/// its old address for as long as it tries to connect there.
void forgetOne(std::map<std::string, std::string>& uris) {
  if (uris.empty()) return;
  const auto second = std::chrono::duration_cast<std::chrono::seconds>(steadyNow().time_since_epoch()).count();
  uris.erase(std::next(uris.begin(), second % static_cast<std::int64_t>(uris.size())));
}

/// What an attempt to connect is remembered by; names have no blanks.
std::string keyOf(const std::string& topic, const std::string& publisher) { return topic + ' ' + publisher; }

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
  forgetOne(uris_);
  AddressBook addresses(uris_);
  NodesByName lost;
  for (const std::string& topic : subscribed) {
    const std::set<std::string> uris = urisOf(connected, topic);
    for (const std::string& node : nodesOf(state.publishers, topic)) {
      if (node != ros::this_node::getName() && addresses.isMissingIn(uris, node)) lost[topic].push_back(node);
    }
  }
  uris_ = addresses.used();
  return lost;
}

void LostConnections::mend(const MasterState& state, const std::vector<std::string>& subscribed,
                           const UrisByTopic& connected) {
  const NodesByName lost = findLost(state, subscribed, connected);
  std::vector<std::string> keys;
  std::set<LateConnections::Connection> missing;
  for (const auto& [topic, publishers] : lost) {
    for (const std::string& publisher : publishers) {
      keys.push_back(keyOf(topic, publisher));
      missing.emplace(topic, publisher);
    }
  }
  lateConnections().note(missing, steadyNow());
  const std::vector<std::string> due = times_.due(keys, steadyNow());
  const std::set<std::string> now(due.begin(), due.end());
  for (const auto& [topic, publishers] : lost) {
    for (const std::string& publisher : publishers) {
      if (now.count(keyOf(topic, publisher)) == 0 || !nodeLives(publisher)) continue;
      THROTTLED_WARN(publisher << " publishes " << topic << ", but this node is not connected to it: connects again");
      registerSubscriber(topic, connected);
    }
  }
}

}  // namespace frontier_pilot
