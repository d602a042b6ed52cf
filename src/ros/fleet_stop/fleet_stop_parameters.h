#pragma once

#include <ros/node_handle.h>

#include <string>
#include <vector>

#include "frontier_pilot/core/parameters.h"
#include "frontier_pilot/fleet/parameters.h"

namespace frontier_pilot {

struct FleetStopParameters {
  std::vector<fleet::FleetRobot> robots;
  double patience = 1.0;  ///< [s]

  template <class Visitor>
  void describe(Visitor& v) {
    v.list("robots", robots,
           "the robots; only their names count here. Robots whose arbiters the master knows are stopped as well");
    v.field("patience", patience, "s", "a robot that has not answered a stop after this time counts as silent",
            between(0.1, 3.0));
  }
  void check(Problems& problems) const;
};

/// The resolved name of the service that stops this robot.
std::string stopOf(const fleet::FleetRobot& robot, const ros::NodeHandle& node);

/// The node's parameters. Throws a ConfigurationError also where a robot has the name of the service that stops all,
/// which would call itself.
FleetStopParameters loadFleetStopParameters(const ros::NodeHandle& node, const ros::NodeHandle& private_node);

}  // namespace frontier_pilot
