#include "frontier_pilot/ros/mapper_adapter.h"
#include "frontier_pilot/ros/node_main.h"

int main(int argc, char** argv) { return frontier_pilot::runNode<frontier_pilot::MapperAdapter>(argc, argv, "mapper"); }
