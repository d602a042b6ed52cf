#include "ros/common/help/usages.h"
#include "ros/common/master/namesake.h"
#include "ros/common/names.h"
#include "ros/common/node_main.h"
#include "ros/waypoint_follower/waypoint_follower_adapter.h"

int main(int argc, char** argv) {
  return frontier_pilot::runNode<frontier_pilot::WaypointFollowerAdapter>(
      argc, argv, frontier_pilot::waypointFollowerUsage(),
      [] { frontier_pilot::refuseASecondServer(frontier_pilot::names::kFollowWaypoints); });
}
