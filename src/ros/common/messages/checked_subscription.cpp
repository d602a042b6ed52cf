#include "ros/common/messages/checked_subscription.h"

namespace frontier_pilot {

void UnreadableMessages::add(const std::string& topic, const std::string& why) noexcept try {
  const std::lock_guard<std::mutex> lock(mutex_);
  by_topic_.try_emplace(topic, "message of " + topic).first->second.add(why);
} catch (...) {  // NOLINT(bugprone-empty-catch): without memory nothing can be counted
}

std::uint64_t UnreadableMessages::total() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  std::uint64_t total = 0;
  for (const auto& [topic, refused] : by_topic_) total += refused.total();
  return total;
}

void UnreadableMessages::report(diagnostic_updater::DiagnosticStatusWrapper& status) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  for (const auto& [topic, refused] : by_topic_) refused.report(status);
}

}  // namespace frontier_pilot
