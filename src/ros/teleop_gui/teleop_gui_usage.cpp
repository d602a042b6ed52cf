#include "ros/common/help/usages.h"

#include <dynamic_reconfigure/Config.h>
#include <frontier_pilot/ArbiterStatus.h>
#include <frontier_pilot/AvoiderStatus.h>
#include <frontier_pilot/ExplorerStatus.h>
#include <frontier_pilot/FleetStopStatus.h>
#include <frontier_pilot/FollowWaypointsAction.h>
#include <frontier_pilot/LoadMap.h>
#include <frontier_pilot/MapChanges.h>
#include <frontier_pilot/NavigatorProgress.h>
#include <frontier_pilot/PatrolAction.h>
#include <frontier_pilot/SaveMap.h>
#include <frontier_pilot/SpinAction.h>
#include <geometry_msgs/Twist.h>
#include <map_msgs/OccupancyGridUpdate.h>
#include <move_base_msgs/MoveBaseAction.h>
#include <nav_msgs/OccupancyGrid.h>
#include <nav_msgs/Path.h>
#include <sensor_msgs/LaserScan.h>
#include <std_msgs/Bool.h>
#include <std_msgs/String.h>
#include <std_srvs/SetBool.h>
#include <std_srvs/Trigger.h>
#include <tf2_msgs/TFMessage.h>
#include <visualization_msgs/MarkerArray.h>

#include "ros/common/names.h"
#include "teleop/parameters.h"

namespace frontier_pilot {

NodeUsage teleopGuiUsage() {
  NodeUsage usage;
  usage.name = "teleop_gui";
  usage.purpose =
      "The operator's window: drive by hand, stop, patrol, turn and explore, send the robot to\n"
      "places on the map, and see who drives and why. Of several robots it shows what each does,\n"
      "and one of them in full.";
  usage.reads = {port<sensor_msgs::LaserScan>(names::kScan),
                 port<geometry_msgs::Twist>(names::kCmdVel),
                 port<ArbiterStatus>(names::kArbiterStatus),
                 port<std_msgs::Bool>(names::kEmergencyStopState),
                 port<AvoiderStatus>(names::kAvoiderStatus),
                 port<dynamic_reconfigure::Config>(names::kAvoiderUpdates),
                 port<ExplorerStatus>(names::kExplorerStatus),
                 port<std_msgs::Bool>(names::kStalled),
                 port<std_msgs::Bool>(names::kLocalized),
                 port<std_msgs::String>(names::kMapReplaced),
                 port<NavigatorProgress>(names::kNavigatorProgress),
                 port<nav_msgs::OccupancyGrid>(names::kMap),
                 port<map_msgs::OccupancyGridUpdate>(names::kMapUpdates),
                 port<MapChanges>(names::changesOf(names::kMap)),
                 port<nav_msgs::Path>(names::kPlan),
                 port<visualization_msgs::MarkerArray>(names::kFrontiers),
                 port<tf2_msgs::TFMessage>(names::kTf),
                 port<tf2_msgs::TFMessage>(names::kTfStatic),
                 port<FleetStopStatus>(names::kFleetStopStatus)};
  usage.publishes = {port<geometry_msgs::Twist>(names::kCmdVelManual)};
  usage.calls = {port<PatrolAction>(names::kPatrol),
                 port<move_base_msgs::MoveBaseAction>(names::kMoveBase),
                 port<SpinAction>(names::kSpin),
                 port<FollowWaypointsAction>(names::kFollowWaypoints),
                 servicePort<SaveMap>(names::kSaveMap),
                 servicePort<LoadMap>(names::kLoadMap),
                 servicePort<std_srvs::Trigger>(names::kEmergencyStop),
                 servicePort<std_srvs::SetBool>(names::kSetEmergencyStop),
                 servicePort<std_srvs::SetBool>(names::kSetObstacleAvoidEnabled),
                 servicePort<std_srvs::SetBool>(names::kSetExplorationEnabled),
                 servicePort<std_srvs::Trigger>(names::kResetExplorer),
                 servicePort<std_srvs::Trigger>(names::kClearExplorationBounds),
                 servicePort<std_srvs::Trigger>(names::kClearInspections),
                 servicePort<std_srvs::SetBool>(names::kSetReturnToStart),
                 servicePort<std_srvs::Trigger>(names::kFleetEmergencyStop)};
  usage.main_parameters = {"linear_step", "angular_step", "hold_to_run", "palette"};
  usage.parameters = describeParameters(teleop::TeleopParameters());
  usage.library_options = {"-platform", "-style", "-geometry", "-display", "-title"};
  usage.example = "rosrun frontier_pilot teleop_gui _palette:=dark";
  return usage;
}

}  // namespace frontier_pilot
