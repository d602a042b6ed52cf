#include "frontier_pilot/ros/behavior_server_adapter.h"
#include "frontier_pilot/ros/node_main.h"

int main(int argc, char** argv) {
  return frontier_pilot::runNode<frontier_pilot::BehaviorServerNode>(argc, argv, "behavior_server");
}
