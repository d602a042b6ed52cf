#include "ros/common/master/publisher_watch.h"

#include <optional>
#include <utility>

#include "ros/common/master/master_state.h"
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

}  // namespace frontier_pilot
