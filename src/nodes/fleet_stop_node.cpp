#include "ros/common/help/usages.h"
#include "ros/common/master/namesake.h"
#include "ros/common/names.h"
#include "ros/common/node_main.h"
#include "ros/fleet_stop/fleet_stop_adapter.h"

int main(int argc, char** argv) {
  return frontier_pilot::runNode<frontier_pilot::FleetStopAdapter>(argc, argv, frontier_pilot::fleetStopUsage(), [] {
    frontier_pilot::refuseASecondProvider(frontier_pilot::names::kFleetEmergencyStop);
  });
}
