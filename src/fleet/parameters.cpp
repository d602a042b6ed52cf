#include "frontier_pilot/fleet/parameters.h"

#include <set>

#include "frontier_pilot/core/bounds.h"
#include "frontier_pilot/core/text.h"

namespace frontier_pilot::fleet {

void MapMergerParameters::check(Problems& problems) const {
  if (robots.size() > kMostRobots) {
    problems.push_back("robots: " + std::to_string(robots.size()) + " are more than " + std::to_string(kMostRobots));
  }
  std::set<std::string> names;
  for (std::size_t i = 0; i < robots.size(); ++i) {
    const FleetRobot& robot = robots[i];
    const std::string entry = "robots[" + std::to_string(i) + "]/";
    if (robot.name.empty()) problems.push_back(entry + "name: missing");
    if (!robot.name.empty() && !isRobotName(robot.name))
      problems.push_back(entry + "name: '" + robot.name + "' is no name of a namespace");
    if (!robot.name.empty() && !names.insert(robot.name).second) {
      problems.push_back(entry + "name: '" + robot.name + "' is there twice");
    }
    if (!bounds::isWithin(robot.x, bounds::kMostCoordinate) || !bounds::isWithin(robot.y, bounds::kMostCoordinate)) {
      problems.push_back(entry + "x, y: farther away than 1000 km");
    }
  }
}

}  // namespace frontier_pilot::fleet
