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

/// All robots that a stop of the fleet reaches, or should reach.
struct FleetView {
  bool connected = false;  ///< the ROS master answers
  bool stop_up = false;    ///< whether all can be stopped together now
  std::vector<RobotView> robots;
  OperatorAnswer stop_answer;  ///< to the last request to stop all robots
};

/// The latest that one robot has said; a part of which nothing was received is empty.
struct RobotReports {
  std::optional<ArbiterView> arbiter;
  std::optional<ExplorerView> explorer;
  std::optional<NavigationView> navigation;
};

/// What `reports` come down to. `reached`: whether a stop of the fleet reaches the robot.
RobotView atAGlance(const std::string& name, const RobotReports& reports, bool reached);

}  // namespace frontier_pilot::teleop
