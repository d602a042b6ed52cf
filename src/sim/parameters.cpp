#include "frontier_pilot/sim/parameters.h"

#include <set>

namespace frontier_pilot::sim {

void SimulatorParameters::check(Problems& problems) const {
  std::set<std::string> names;
  for (const RobotSpec& spec : robots) {
    if (!names.insert(spec.name).second) problems.push_back("robots: two are named '" + spec.name + "'");
  }
  if (names.size() > 1 && names.count("") > 0) problems.emplace_back("robots: of several each must have a name");
}

}  // namespace frontier_pilot::sim
