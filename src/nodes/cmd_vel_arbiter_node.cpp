#include "frontier_pilot/ros/cmd_vel_arbiter_adapter.h"
#include "frontier_pilot/ros/node_main.h"

int main(int argc, char** argv) {
  return frontier_pilot::runNode<frontier_pilot::CmdVelArbiterNode>(argc, argv, "cmd_vel_arbiter",
                                                                    frontier_pilot::refuseASecondArbiter);
}
