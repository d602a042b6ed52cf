#include "ros/fleet_stop/known_robots.h"

#include <chrono>
#include <iterator>

namespace frontier_pilot {
namespace {

constexpr Duration kForgotten = std::chrono::hours(1);

}  // namespace

void KnownRobots::see(const std::string& service, SteadyTime now) {
  const auto [robot, is_new] = seen_.emplace(service, now);
  if (!is_new && robot->second) robot->second = now;
}

std::vector<std::string> KnownRobots::forget(SteadyTime now) {
  std::vector<std::string> forgotten;
  for (auto robot = seen_.begin(); robot != seen_.end();) {
    const bool is_gone = robot->second && now - *robot->second > kForgotten;
    if (is_gone) forgotten.push_back(robot->first);
    robot = is_gone ? seen_.erase(robot) : std::next(robot);
  }
  return forgotten;
}

}  // namespace frontier_pilot
