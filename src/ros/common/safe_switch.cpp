#include "ros/common/safe_switch.h"
#include "ros/common/master/ros_sessions.h"

#include <ros/console.h>
#include <ros/names.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "ros/common/throttled_log.h"

namespace frontier_pilot {
namespace {

constexpr const char* kNot = "not ";

}  // namespace

SafeSwitch::SafeSwitch(std::string state, const std::string& service, NodeConnections& connections)
    : state_(std::move(state)),
      report_(connections.memory()),
      memory_(rosHome(), rosSessions(), state_, ros::names::resolve(service), SessionMemory::Owner::kService) {
  // A file that cannot be read counts as safe, and if two files differ the safe side wins.
  const std::vector<std::string> left = memory_.recallAll();
  const auto isSafe = [this](const std::string& text) { return text != kNot + state_; };
  if (!left.empty()) safe_ = std::any_of(left.begin(), left.end(), isSafe);
  write();
  connections.master().onRenewal([this] {
    const std::vector<std::string> sessions = rosSessions();
    const std::lock_guard<std::mutex> lock(mutex_);
    if (memory_.enter(sessions)) write();
  });
  // Repeatedly, because a disk may be full for a while, and files may be deleted. For a switch that was never used it
  // is only checked whether it could be stored, so that the operator learns of a problem before relying on it.
  connections.everySteady(ros::WallDuration(1.0), [this] {
    const std::lock_guard<std::mutex> lock(mutex_);
    write();
  });
}

SafeSwitch::~SafeSwitch() {
  if (safe_ == false) memory_.forget();
  memory_.endInOrder();
}

std::optional<bool> SafeSwitch::wasLeftSafe() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (safe_) ROS_WARN_STREAM("starts " << (*safe_ ? "" : kNot) << state_ << ", as the operator left it");
  return safe_;
}

std::string SafeSwitch::set(bool safe) {
  const std::lock_guard<std::mutex> lock(mutex_);
  safe_ = safe;
  const std::string problem = write();
  return problem.empty() ? problem : "; would not survive a restart: " + problem;
}

std::string SafeSwitch::write() const {
  std::string problem = safe_ ? memory_.remember((*safe_ ? "" : kNot) + state_) : memory_.problem();
  report_.setProblem(state_, problem);
  if (safe_ && !problem.empty()) THROTTLED_WARN(state_ << " would not survive a restart: " << problem);
  return problem;
}

}  // namespace frontier_pilot
