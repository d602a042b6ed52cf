#include "frontier_pilot/ros/explorer_adapter.h"
#include "frontier_pilot/ros/node_main.h"

int main(int argc, char** argv) {
  return frontier_pilot::runNode<frontier_pilot::ExplorerAdapter>(argc, argv, "frontier_explorer");
}
