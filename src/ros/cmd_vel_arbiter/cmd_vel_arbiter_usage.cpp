#include "ros/common/help/usages.h"

#include <frontier_pilot/ArbiterStatus.h>
#include <geometry_msgs/Twist.h>
#include <std_msgs/Bool.h>
#include <std_srvs/SetBool.h>
#include <std_srvs/Trigger.h>

#include "ros/cmd_vel_arbiter/cmd_vel_arbiter_adapter.h"
#include "ros/common/names.h"

namespace frontier_pilot {

NodeUsage cmdVelArbiterUsage() {
  NodeUsage usage;
  usage.name = "cmd_vel_arbiter";
  usage.purpose =
      "Forwards the commands of the source with the highest priority to the wheels, and latches the emergency\n"
      "stop. Nothing else may publish cmd_vel.";
  usage.reads = {port<geometry_msgs::Twist>(names::kCmdVelAvoid),  port<geometry_msgs::Twist>(names::kCmdVelBehavior),
                 port<geometry_msgs::Twist>(names::kCmdVelPatrol), port<geometry_msgs::Twist>(names::kCmdVelNav),
                 port<geometry_msgs::Twist>(names::kCmdVelManual), port<std_msgs::Bool>(names::kEmergencyStopState)};
  usage.publishes = {port<geometry_msgs::Twist>(names::kCmdVel), port<ArbiterStatus>(names::kArbiterStatus),
                     port<std_msgs::Bool>(names::kEmergencyStopState)};
  usage.services = {servicePort<std_srvs::Trigger>(names::kEmergencyStop),
                    servicePort<std_srvs::SetBool>(names::kSetEmergencyStop)};
  for (const arbiter::SourceParameters& source : arbiter::ArbiterParameters().sources)
    usage.services.push_back(servicePort<std_srvs::SetBool>(names::setEnabled(source.name)));
  addTuningPorts(usage);
  usage.main_parameters = {"sources[i]/name", "sources[i]/topic", "sources[i]/priority", "sources[i]/timeout"};
  usage.parameters = describeParameters(arbiter::ArbiterParameters());
  usage.example = "rosrun frontier_pilot cmd_vel_arbiter cmd_vel:=/base/cmd_vel";
  return usage;
}

}  // namespace frontier_pilot
