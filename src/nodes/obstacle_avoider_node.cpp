#include "frontier_pilot/ros/node_main.h"
#include "frontier_pilot/ros/obstacle_avoider_adapter.h"

int main(int argc, char** argv) {
  return frontier_pilot::runNode<frontier_pilot::ObstacleAvoiderNode>(argc, argv, "obstacle_avoider");
}
