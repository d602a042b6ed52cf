#include "ros/common/inputs/navigation_permission.h"

#include <ros/names.h>

#include <algorithm>
#include <vector>

#include "ros/common/inputs/arbiter_source.h"
#include "ros/common/names.h"

namespace frontier_pilot {
namespace {

/// What nobody ends but a person.
constexpr Duration kAtOnce = Duration::zero();
/// For a node that is restarted, for instance.
constexpr Duration kMoment = std::chrono::seconds(2);
/// A recovery of the avoider takes up to 14.4 s by its defaults (12 cycles of 1.2 s) before it is stuck, and a full
/// turn of the behaviours some 10 s: the navigation drives on after these. It calls itself blocked only later.
constexpr Duration kEpisode = std::chrono::seconds(20);

bool isAmong(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

}  // namespace

NavigationPermission::NavigationPermission() : NavigationPermission(ros::names::resolve(names::kCmdVelNav)) {}

std::optional<NavigationPermission::Refusal> NavigationPermission::find(const ArbiterStatus& status) const {
  const ArbiterSource* navigation = findSource(status, topic_);
  if (navigation == nullptr) return std::nullopt;
  if (navigation->enabled == 0) return Refusal{"its source " + navigation->name + " is disabled", kAtOnce};
  if (status.state == ArbiterStatus::CONTESTED)
    return Refusal{"another node could receive an emergency stop in its place", kMoment};
  if (status.state == ArbiterStatus::UNREACHABLE) return Refusal{"no emergency stop could be called", kMoment};
  for (const ArbiterSource& source : status.sources) {
    if (source.priority <= navigation->priority) continue;
    if (isAmong(status.missing_sources, source.name))
      return Refusal{"its source " + source.name + " is required but silent", kMoment};
    if (status.state == ArbiterStatus::DRIVING && source.name == status.active_source)
      return Refusal{"its source " + source.name + " has the wheels", kEpisode};
  }
  return std::nullopt;
}

void NavigationPermission::take(const ArbiterStatus& status, Time now, SteadyTime received) {
  const auto found = find(status);
  const bool goes_on = found && last_.has() && last_.get()->passes == found->passes && since_ <= now;
  if (!goes_on) since_ = now;
  last_.clear();
  if (found) last_.put(*found, received);
}

std::string NavigationPermission::refusal(Time now, SteadyTime steady) const {
  constexpr Duration kLifetime = std::chrono::seconds(5);  // of a status, which comes each second
  const auto last = last_.fresh(steady, kLifetime);
  return last && now - since_ >= last->passes ? last->why : "";
}

}  // namespace frontier_pilot
