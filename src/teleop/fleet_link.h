#pragma once

#include <memory>
#include <string>

#include "teleop/fleet_view.h"
#include "teleop/operator_link.h"
#include "teleop/parameters.h"

namespace frontier_pilot::teleop {

/// The operator's window's access to several robots, of which it shows one whole. No call waits for a robot. [GUI-3]
class FleetLink {
 public:
  virtual ~FleetLink() = default;

  /// Without a fleet it has no robots.
  virtual FleetView fleet() = 0;
  /// The robot of that name as it describes itself; with an empty name, that of the window's own parameters.
  virtual TeleopParameters parametersOf(const std::string& robot) = 0;
  /// The access to one robot; with an empty name, to the one in the window's own namespace.
  virtual std::unique_ptr<OperatorLink> open(const std::string& robot, const TeleopParameters& parameters) = 0;
  virtual void stopAll() = 0;
};

}  // namespace frontier_pilot::teleop
