#include "frontier_pilot/ros/safe_switch.h"

#include <ros/console.h>
#include <ros/this_node.h>

#include <utility>

#include "frontier_pilot/ros/throttled_log.h"

namespace frontier_pilot {

SafeSwitch::SafeSwitch(std::string state, NodeConnections& connections)
    : state_(std::move(state)),
      memory_(rosHome(), rosSessions(), state_, ros::this_node::getName()),
      safe_(memory_.recall().has_value()) {
  connections.master().onRenewal([this] {
    const std::vector<std::string> sessions = rosSessions();
    const std::lock_guard<std::mutex> lock(mutex_);
    if (memory_.enter(sessions) && safe_) write();
  });
}

bool SafeSwitch::wasLeftSafe() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (safe_) ROS_WARN_STREAM("comes up " << state_ << ", as it was left");
  return safe_;
}

void SafeSwitch::set(bool safe) {
  const std::lock_guard<std::mutex> lock(mutex_);
  safe_ = safe;
  write();
}

void SafeSwitch::write() const {
  const std::string problem = safe_ ? memory_.remember(state_) : memory_.forget();
  if (!problem.empty()) THROTTLED_WARN(state_ << " would not survive a restart: " << problem);
}

}  // namespace frontier_pilot
