#include "ros/common/master/publisher_watch.h"

#include "ros/common/clock.h"
#include "ros/common/master/registration.h"

namespace frontier_pilot {

void PublisherWatch::add(const std::string& topic) {
  const std::lock_guard<std::mutex> lock(mutex_);
  topics_.insert(topic);
}

void PublisherWatch::look() {
  std::set<std::string> topics;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    topics = topics_;
  }
  if (topics.empty()) return;
  const std::optional<UrisByTopic> connected = connectedPublishers();
  if (!connected) return;
  std::set<std::string> dead;
  for (const std::string& topic : topics) {
    const std::set<std::string> uris = urisOf(*connected, topic);
    if (!uris.empty() && !anyMayLivePatiently(uris)) dead.insert(topic);
  }
  const std::lock_guard<std::mutex> lock(mutex_);
  dead_ = std::move(dead);
}

bool PublisherWatch::mayBePublished(const std::string& topic) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return dead_.count(topic) == 0;
}

std::optional<bool> NodeWatch::lives(const std::string& node, SteadyTime since) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto found = found_.find(node);
  if (found != found_.end() && found->second.time >= since) return found->second.lives;
  asked_.insert(node);
  return std::nullopt;
}

void NodeWatch::look() {
  std::set<std::string> asked;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    asked.swap(asked_);
  }
  if (asked.empty()) return;
  std::map<std::string, Finding> found;
  for (const std::string& node : asked) {
    const SteadyTime now = steadyNow();
    if (const auto lives = question_(node)) found[node] = {*lives, now};
  }
  const std::lock_guard<std::mutex> lock(mutex_);
  found_ = std::move(found);
}

}  // namespace frontier_pilot
