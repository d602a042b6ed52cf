#include "frontier_pilot/ros/node_main.h"
#include "frontier_pilot/ros/patrol_server_adapter.h"

int main(int argc, char** argv) {
  return frontier_pilot::runNode<frontier_pilot::PatrolServerNode>(argc, argv, "patrol_server");
}
