#include "ros/common/help/usages.h"
#include "ros/common/master/namesake.h"
#include "ros/common/names.h"
#include "ros/common/node_main.h"
#include "ros/patrol_server/patrol_server_adapter.h"

int main(int argc, char** argv) {
  return frontier_pilot::runNode<frontier_pilot::PatrolServerAdapter>(
      argc, argv, frontier_pilot::patrolServerUsage(),
      [] { frontier_pilot::refuseASecondServer(frontier_pilot::names::kPatrol); });
}
