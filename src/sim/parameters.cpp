#include "frontier_pilot/sim/parameters.h"

#include <cmath>
#include <set>

#include "frontier_pilot/core/text.h"
#include "frontier_pilot/sim/simulator.h"

namespace frontier_pilot::sim {

void SimulatorParameters::check(Problems& problems) const {
  std::set<std::string> names;
  for (const RobotSpec& spec : robots) {
    if (!spec.name.empty() && !isRobotName(spec.name))
      problems.push_back("robots: '" + spec.name + "' is no name of a namespace");
    if (!names.insert(spec.name).second) problems.push_back("robots: two are named '" + spec.name + "'");
  }
  if (names.size() > 1 && names.count("") > 0) problems.emplace_back("robots: of several each must have a name");
  std::set<std::string> known{""};
  for (const RobotKind& kind : kinds) {
    if (kind.name.empty())
      problems.emplace_back("kinds: each must have a name");
    else if (!known.insert(kind.name).second)
      problems.push_back("kinds: two are named '" + kind.name + "'");
  }
  for (const RobotSpec& spec : robots) {
    if (known.count(spec.robot) == 0)
      problems.push_back("robots: '" + spec.name + "' is to be a '" + spec.robot + "', which is none of the kinds");
  }
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
