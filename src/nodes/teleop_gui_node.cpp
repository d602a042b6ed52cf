#include "frontier_pilot/gui/pilot_window.h"
#include "frontier_pilot/ros/gui_bridge.h"
#include "frontier_pilot/ros/node_main.h"
#include "frontier_pilot/ros/parameters.h"

using frontier_pilot::GuiBridge;
using frontier_pilot::TeleopParameters;

int main(int argc, char** argv) {
  return frontier_pilot::runNodeWithLoop(
      argc, argv, "teleop_gui",
      [&](ros::NodeHandle& node, ros::NodeHandle& private_node, const frontier_pilot::RunningFn& running) {
        const auto parameters = frontier_pilot::loadNodeParameters<TeleopParameters>(private_node);
        GuiBridge bridge(node, parameters, GuiBridge::Manual::kAlways, running);
        return frontier_pilot::runPilotWindow(argc, argv, bridge, parameters);
      });
}
