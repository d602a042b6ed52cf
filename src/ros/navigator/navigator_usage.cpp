#include "ros/common/help/usages.h"

#include <frontier_pilot/ArbiterStatus.h>
#include <frontier_pilot/FleetMotion.h>
#include <frontier_pilot/MapChanges.h>
#include <frontier_pilot/NavigatorProgress.h>
#include <geometry_msgs/PoseStamped.h>
#include <geometry_msgs/Twist.h>
#include <map_msgs/OccupancyGridUpdate.h>
#include <move_base_msgs/MoveBaseAction.h>
#include <nav_msgs/GetPlan.h>
#include <nav_msgs/OccupancyGrid.h>
#include <nav_msgs/Odometry.h>
#include <nav_msgs/Path.h>
#include <sensor_msgs/LaserScan.h>
#include <std_msgs/Bool.h>
#include <std_msgs/String.h>
#include <std_srvs/Empty.h>
#include <tf2_msgs/TFMessage.h>

#include "ros/common/names.h"
#include "ros/navigator/navigator_adapter.h"

namespace frontier_pilot {

NodeUsage navigatorUsage() {
  NodeUsage usage;
  usage.name = names::kNavigatorNode;
  usage.purpose =
      "Drives to goals on the map: plans a path, follows it past obstacles that the scan shows, and recovers when\n"
      "it is stuck. Takes the place of move_base.";
  usage.reads = {port<nav_msgs::OccupancyGrid>(names::kMap),
                 port<map_msgs::OccupancyGridUpdate>(names::kMapUpdates),
                 port<MapChanges>(names::changesOf(names::kMap)),
                 port<sensor_msgs::LaserScan>(names::kScan),
                 port<nav_msgs::Odometry>(names::kOdom),
                 port<geometry_msgs::PoseStamped>(names::kSimpleGoal),
                 port<std_msgs::Bool>(names::kEmergencyStopState),
                 port<ArbiterStatus>(names::kArbiterStatus),
                 port<std_msgs::Bool>(names::kLocalized),
                 port<std_msgs::String>(names::kMapReplaced),
                 port<tf2_msgs::TFMessage>(names::kTf),
                 port<tf2_msgs::TFMessage>(names::kTfStatic),
                 port<FleetMotion>(names::kFleetMotions)};
  usage.publishes = {port<geometry_msgs::Twist>(names::kCmdVelNav),
                     port<nav_msgs::Path>(names::kPlan),
                     port<nav_msgs::Path>(names::kLocalPlan),
                     port<nav_msgs::OccupancyGrid>(names::kLocalCostmap),
                     port<nav_msgs::OccupancyGrid>(names::kGlobalCostmap),
                     port<std_msgs::String>(names::kNavigatorStatus),
                     port<NavigatorProgress>(names::kNavigatorProgress),
                     port<geometry_msgs::PoseStamped>(names::kCurrentGoal),
                     port<FleetMotion>(names::kFleetMotions)};
  usage.services = {servicePort<nav_msgs::GetPlan>(names::kMakePlan),
                    servicePort<std_srvs::Empty>(names::kClearCostmaps)};
  usage.actions = {port<move_base_msgs::MoveBaseAction>(names::kMoveBase)};
  addTuningPorts(usage);
  usage.main_parameters = {"clearance/preferred_clearance", "clearance/unknown_is_traversable", "goal_tolerance",
                           "yaw_tolerance", "use_goal_yaw"};
  usage.parameters = describeParameters(NavigatorNodeParameters());
  usage.example = "rosrun frontier_pilot navigator _goal_tolerance:=0.1";
  return usage;
}

}  // namespace frontier_pilot
