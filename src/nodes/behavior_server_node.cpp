#include "ros/behavior_server/behavior_server_adapter.h"
#include "ros/common/help/usages.h"
#include "ros/common/master/namesake.h"
#include "ros/common/names.h"
#include "ros/common/node_main.h"

int main(int argc, char** argv) {
  return frontier_pilot::runNode<frontier_pilot::BehaviorServerAdapter>(
      argc, argv, frontier_pilot::behaviorServerUsage(),
      [] { frontier_pilot::refuseASecondServer(frontier_pilot::names::kSpin); });
}
