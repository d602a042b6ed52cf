#include "frontier_pilot/ros/navigator_adapter.h"
#include "frontier_pilot/ros/node_main.h"

int main(int argc, char** argv) {
  return frontier_pilot::runNode<frontier_pilot::NavigatorAdapter>(argc, argv, "navigator");
}
