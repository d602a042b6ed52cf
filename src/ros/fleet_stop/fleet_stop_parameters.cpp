#include "ros/fleet_stop/fleet_stop_parameters.h"

#include "frontier_pilot/core/text.h"
#include "ros/common/names.h"
#include "ros/common/parameters.h"

namespace frontier_pilot {

void FleetStopParameters::check(Problems& problems) const {
  for (const fleet::FleetRobot& robot : robots) {
    // One that begins with a slash is not below the namespace of this node.
    const bool is_absolute = robot.name.rfind('/', 0) == 0;
    if (!isRobotName(robot.name.substr(is_absolute ? 1 : 0)))
      problems.push_back("robots: '" + robot.name + "' is no name of a namespace");
  }
}

std::string stopOf(const fleet::FleetRobot& robot, const ros::NodeHandle& node) {
  return node.resolveName(names::ofRobot(robot.name, names::kEmergencyStop));
}

FleetStopParameters loadFleetStopParameters(const ros::NodeHandle& node, const ros::NodeHandle& private_node) {
  auto parameters = loadNodeParameters<FleetStopParameters>(private_node);
  Problems problems;
  for (const fleet::FleetRobot& robot : parameters.robots) {
    if (stopOf(robot, node) == node.resolveName(names::kFleetEmergencyStop))
      problems.push_back("robots: '" + robot.name + "' cannot be a robot's name: " + names::kFleetEmergencyStop +
                         " stops all robots");
  }
  if (!problems.empty()) throw ConfigurationError(private_node.getNamespace(), problems);
  return parameters;
}

}  // namespace frontier_pilot
