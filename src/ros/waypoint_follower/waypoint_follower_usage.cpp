#include "ros/common/help/usages.h"

#include <frontier_pilot/ArbiterStatus.h>
#include <frontier_pilot/FollowWaypointsAction.h>
#include <geometry_msgs/PoseArray.h>
#include <geometry_msgs/PoseStamped.h>
#include <move_base_msgs/MoveBaseAction.h>
#include <std_msgs/Bool.h>
#include <std_msgs/String.h>
#include <std_srvs/Trigger.h>

#include "ros/common/names.h"
#include "waypoints/waypoint_follower.h"

namespace frontier_pilot {

NodeUsage waypointFollowerUsage() {
  NodeUsage usage;
  usage.name = "waypoint_follower";
  usage.purpose =
      "Drives through waypoints in their order, each a goal of move_base: those of an action, or those that were\n"
      "collected one by one, as rviz publishes them.";
  usage.reads = {port<geometry_msgs::PoseStamped>(names::kAddWaypoint),
                 port<std_msgs::Bool>(names::kEmergencyStopState), port<ArbiterStatus>(names::kArbiterStatus),
                 port<std_msgs::String>(names::kMapReplaced)};
  usage.publishes = {port<geometry_msgs::PoseArray>(names::kWaypoints)};
  usage.services = {servicePort<std_srvs::Trigger>(names::kStartWaypoints),
                    servicePort<std_srvs::Trigger>(names::kClearWaypoints)};
  usage.actions = {port<FollowWaypointsAction>(names::kFollowWaypoints)};
  usage.calls = {port<move_base_msgs::MoveBaseAction>(names::kMoveBase)};
  usage.main_parameters = {"stop_on_failure"};
  usage.parameters = describeParameters(waypoints::WaypointParameters());
  usage.example = "rosrun frontier_pilot waypoint_follower _stop_on_failure:=true";
  return usage;
}

}  // namespace frontier_pilot
