#include "ros/common/memory/safe_switch.h"

#include <ros/console.h>
#include <ros/names.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "ros/common/memory/disk.h"

namespace frontier_pilot {
namespace {

constexpr const char* kNot = "not ";

}  // namespace

SafeSwitch::SafeSwitch(std::string state, const std::string& service, NodeConnections& connections)
    : state_(std::move(state)),
      memory_(state_, ros::names::resolve(service), SessionMemory::Owner::kService, connections, spareFolder()) {
  // A file that cannot be read counts as safe, and if two files differ the safe side wins. Of a session whose master
  // has been replaced, and of another launch, only the safe side counts.
  const std::vector<std::string>& left = memory_.left();
  const bool safe =
      std::any_of(left.begin(), left.end(), [this](const std::string& text) { return text != kNot + state_; });
  if (safe || memory_.leftByThisLaunch().size() > memory_.leftElsewhere().size()) set(safe);
}

std::optional<bool> SafeSwitch::wasLeftSafe() const {
  if (safe_) ROS_WARN_STREAM("starts with " << state_ << (*safe_ ? " on" : " off") << ", as the operator left it");
  return safe_;
}

std::string SafeSwitch::set(bool safe) {
  safe_ = safe;
  const std::string problem = memory_.set((safe ? "" : kNot) + state_);
  return problem.empty() ? problem : "; would not survive this node: " + problem;
}

}  // namespace frontier_pilot
