#include "ros/behavior_server/behavior_server_adapter.h"
#include "ros/common/help/usages.h"
#include "ros/common/node_main.h"

int main(int argc, char** argv) {
  return frontier_pilot::runNode<frontier_pilot::BehaviorServerAdapter>(argc, argv,
                                                                        frontier_pilot::behaviorServerUsage());
}
