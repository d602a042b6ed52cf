#include "ros/common/help/usages.h"
#include "ros/common/master/namesake.h"
#include "ros/common/names.h"
#include "ros/common/node_main.h"
#include "ros/obstacle_avoider/obstacle_avoider_adapter.h"

int main(int argc, char** argv) {
  return frontier_pilot::runNode<frontier_pilot::ObstacleAvoiderAdapter>(
      argc, argv, frontier_pilot::obstacleAvoiderUsage(),
      [] { frontier_pilot::refuseASecondProvider(frontier_pilot::names::kSetObstacleAvoidEnabled); });
}
