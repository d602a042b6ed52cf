#include "gui/pilot_window.h"
#include "ros/common/help/usages.h"
#include "ros/common/logging/console_output.h"
#include "ros/common/node_main.h"
#include "ros/common/parameters.h"
#include "ros/teleop_gui/fleet_bridge.h"

using frontier_pilot::FleetBridge;
using frontier_pilot::teleop::TeleopParameters;

int main(int argc, char** argv) {
  return frontier_pilot::runNodeWithLoop(
      argc, argv, frontier_pilot::teleopGuiUsage(),
      [&](ros::NodeHandle& node, ros::NodeHandle& private_node, const frontier_pilot::RunningFn& running) {
        frontier_pilot::dropUnreadOutput();
        const auto parameters = frontier_pilot::loadNodeParameters<TeleopParameters>(private_node);
        FleetBridge bridge(node, parameters, running);
        return frontier_pilot::gui::runPilotWindow(argc, argv, bridge, parameters.palette,
                                                   frontier_pilot::sayWhyNoWindow, frontier_pilot::limitTheEnd);
      });
}
