#include "support/shipped_robot.h"

#include <stdexcept>

#include "frontier_pilot/core/parameters.h"

namespace frontier_pilot::test {

RobotModel shippedRobot(const std::string& name) {
  RobotModel robot;
  const std::string file = std::string(PROJECT_ROOT) + "/config/robots/" + name + ".yaml";
  const Problems problems = loadParameters(loadYamlFile(file), robot);
  if (!problems.empty()) throw std::invalid_argument(file + ": " + problems.front());
  return robot;
}

}  // namespace frontier_pilot::test
