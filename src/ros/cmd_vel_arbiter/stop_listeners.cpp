#include "ros/cmd_vel_arbiter/stop_listeners.h"

#include <algorithm>

namespace frontier_pilot {
namespace {

constexpr Duration kConnectPatience = std::chrono::seconds(10);

}  // namespace

void StopListeners::disconnect(const std::string& node) {
  if (const auto one = connected_.find(node); one != connected_.end()) connected_.erase(one);
}

bool StopListeners::mayBeAwaited(SteadyTime now) const { return now - begun_ < kConnectPatience; }

bool StopListeners::areAwaited(SteadyTime now) const {
  if (!mayBeAwaited(now)) return false;
  return !listed_ || !std::all_of(listed_->begin(), listed_->end(), [this](const std::string& node) {
    return node == self_ || connected_.count(node) > 0;
  });
}

}  // namespace frontier_pilot
