#include "ros/cmd_vel_arbiter/cmd_vel_arbiter_adapter.h"
#include "ros/common/node_main.h"

int main(int argc, char** argv) {
  return frontier_pilot::runNode<frontier_pilot::CmdVelArbiterAdapter>(argc, argv, "cmd_vel_arbiter",
                                                                       frontier_pilot::refuseASecondArbiter);
}
