#include "frontier_pilot/ros/node_main.h"
#include "frontier_pilot/ros/simulator_adapter.h"

int main(int argc, char** argv) {
  return frontier_pilot::runNode<frontier_pilot::SimulatorAdapter>(argc, argv, "simulator");
}
