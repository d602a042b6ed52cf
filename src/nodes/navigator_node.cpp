#include "ros/common/help/usages.h"
#include "ros/common/master/namesake.h"
#include "ros/common/names.h"
#include "ros/common/node_main.h"
#include "ros/navigator/navigator_adapter.h"

int main(int argc, char** argv) {
  return frontier_pilot::runNode<frontier_pilot::NavigatorAdapter>(argc, argv, frontier_pilot::navigatorUsage(), [] {
    frontier_pilot::refuseASecondServer(frontier_pilot::names::kMoveBase);
  });
}
