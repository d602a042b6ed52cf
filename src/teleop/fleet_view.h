#pragma once

#include <optional>
#include <string>
#include <vector>

#include "teleop/operator_state.h"

/// What an operator of several robots is shown of all of them, as plain data without ROS or Qt.
namespace frontier_pilot::teleop {

/// One robot at a glance.
struct RobotView {
  std::string name;
  Severity severity = Severity::kIdle;
  std::string text;  ///< what it does, or why it stands
};

/// What has become of the last request to stop all robots, or why there can be none; empty: nothing to say.
struct FleetStopView {
  Severity severity = Severity::kIdle;
  std::string text;
};

/// All robots that a stop of the fleet reaches, or should reach.
struct FleetView {
  bool connected = false;  ///< the ROS master answers
  std::vector<RobotView> robots;
  FleetStopView stop;
};

/// The latest that one robot has said; what has not been received is empty.
struct RobotReports {
  std::optional<ArbiterView> arbiter;
  std::optional<ExplorerView> explorer;
  std::optional<NavigationView> navigation;
};

/// A summary of `reports` in one line. `reached`: whether a stop of the fleet reaches the robot.
RobotView atAGlance(const std::string& name, const RobotReports& reports, bool reached);

}  // namespace frontier_pilot::teleop
