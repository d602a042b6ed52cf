#include "ros/common/messages/heard_publishers.h"

namespace frontier_pilot {
namespace {

constexpr Duration kOfLate = std::chrono::seconds(3);
constexpr std::size_t kMostNames = 8;  ///< enough for the operator

bool isOld(SteadyTime then, SteadyTime now) { return now - then > kOfLate; }

}  // namespace

void HeardPublishers::add(const std::string& node, SteadyTime now) {
  const auto found = last_.find(node);
  if (found != last_.end()) {
    found->second = now;
    return;
  }
  for (auto entry = last_.begin(); entry != last_.end();)
    entry = isOld(entry->second, now) ? last_.erase(entry) : ++entry;
  if (last_.size() < kMostNames) last_[node] = now;
}

std::string HeardPublishers::severalNames(SteadyTime now) const {
  std::string names;
  int count = 0;
  for (const auto& [node, when] : last_) {
    if (isOld(when, now)) continue;
    names += (count++ > 0 ? ", " : "") + node;
  }
  return count > 1 ? names : "";
}

}  // namespace frontier_pilot
