#include "ros/common/help/usages.h"
#include "ros/common/master/namesake.h"
#include "ros/common/names.h"
#include "ros/common/node_main.h"
#include "ros/frontier_explorer/frontier_explorer_adapter.h"

int main(int argc, char** argv) {
  return frontier_pilot::runNode<frontier_pilot::FrontierExplorerAdapter>(
      argc, argv, frontier_pilot::frontierExplorerUsage(),
      [] { frontier_pilot::refuseASecondProvider(frontier_pilot::names::kSetExplorationEnabled); });
}
