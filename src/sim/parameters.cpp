#include "frontier_pilot/sim/parameters.h"

#include <cmath>
#include <set>

#include "frontier_pilot/sim/simulator.h"

namespace frontier_pilot::sim {

void SimulatorParameters::check(Problems& problems) const {
  std::set<std::string> names;
  for (const RobotSpec& spec : robots) {
    if (!names.insert(spec.name).second) problems.push_back("robots: two are named '" + spec.name + "'");
  }
  if (names.size() > 1 && names.count("") > 0) problems.emplace_back("robots: of several each must have a name");
}

std::vector<RobotSpec> robotsOf(const SimulatorParameters& parameters, const World& world) {
  if (!parameters.robots.empty()) return parameters.robots;
  const bool placed = !std::isnan(parameters.x) || !std::isnan(parameters.y);
  const Pose2 anywhere(std::nan(""), std::nan(""), 0.0);
  const Pose2 fallback = placed ? Pose2{} : world.start.value_or(anywhere);
  const auto given = [](double value, double otherwise) { return std::isnan(value) ? otherwise : value; };
  return {{"", given(parameters.x, fallback.x), given(parameters.y, fallback.y), given(parameters.yaw, fallback.yaw)}};
}

}  // namespace frontier_pilot::sim
