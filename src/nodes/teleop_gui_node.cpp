#include "frontier_pilot/gui/pilot_window.h"
#include "frontier_pilot/ros/gui_bridge.h"
#include "frontier_pilot/ros/node_main.h"
#include "frontier_pilot/ros/parameters.h"

using namespace frontier_pilot;

int main(int argc, char** argv) {
  return runNodeWithLoop(argc, argv, "teleop_gui",
                         [&](ros::NodeHandle& node, ros::NodeHandle& private_node, const RunningFn& running) {
                           const auto parameters = loadNodeParameters<TeleopParameters>(private_node);
                           GuiBridge bridge(node, parameters, GuiBridge::Manual::kAlways, running);
                           return runPilotWindow(argc, argv, bridge, parameters);
                         });
}
