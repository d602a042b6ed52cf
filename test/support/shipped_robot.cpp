#include "support/shipped_robot.h"

namespace frontier_pilot::test {

RobotModel shippedRobot(const std::string& name) {
  return loadRobot(std::string(PROJECT_ROOT) + "/config/robots/" + name + ".yaml");
}

}  // namespace frontier_pilot::test
