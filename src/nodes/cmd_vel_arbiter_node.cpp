#include "ros/cmd_vel_arbiter/cmd_vel_arbiter_adapter.h"
#include "ros/common/help/usages.h"
#include "ros/common/node_main.h"

int main(int argc, char** argv) {
  return frontier_pilot::runNode<frontier_pilot::CmdVelArbiterAdapter>(argc, argv, frontier_pilot::cmdVelArbiterUsage(),
                                                                       frontier_pilot::refuseASecondArbiter);
}
