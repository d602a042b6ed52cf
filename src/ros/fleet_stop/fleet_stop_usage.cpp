#include <frontier_pilot/FleetStopStatus.h>
#include <std_srvs/Trigger.h>

#include "ros/common/help/usages.h"
#include "ros/common/names.h"
#include "ros/fleet_stop/fleet_stop_adapter.h"

namespace frontier_pilot {

NodeUsage fleetStopUsage() {
  NodeUsage usage;
  usage.name = "fleet_stop";
  usage.purpose =
      "Stops all robots with one call, which is answered when each has confirmed it and names those that have not.\n"
      "A stop is cleared at each robot.";
  usage.publishes = {port<FleetStopStatus>(names::kFleetStopStatus)};
  usage.services = {servicePort<std_srvs::Trigger>(names::kFleetEmergencyStop)};
  usage.main_parameters = {"patience"};
  usage.parameters = describeParameters(FleetStopParameters());
  usage.example = "rosrun frontier_pilot fleet_stop _patience:=0.5";
  return usage;
}

}  // namespace frontier_pilot
