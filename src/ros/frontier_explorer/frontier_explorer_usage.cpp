#include "ros/common/help/usages.h"

#include <frontier_pilot/ArbiterStatus.h>
#include <frontier_pilot/ExplorerStatus.h>
#include <frontier_pilot/FleetClaims.h>
#include <frontier_pilot/MapChanges.h>
#include <frontier_pilot/SaveMap.h>
#include <frontier_pilot/SetBounds.h>
#include <geometry_msgs/PointStamped.h>
#include <geometry_msgs/PoseStamped.h>
#include <map_msgs/OccupancyGridUpdate.h>
#include <move_base_msgs/MoveBaseAction.h>
#include <nav_msgs/OccupancyGrid.h>
#include <nav_msgs/Odometry.h>
#include <sensor_msgs/BatteryState.h>
#include <std_msgs/Bool.h>
#include <std_msgs/String.h>
#include <std_srvs/SetBool.h>
#include <std_srvs/Trigger.h>
#include <tf2_msgs/TFMessage.h>
#include <visualization_msgs/MarkerArray.h>

#include "ros/common/names.h"
#include "ros/frontier_explorer/frontier_explorer_adapter.h"

namespace frontier_pilot {

NodeUsage frontierExplorerUsage() {
  NodeUsage usage;
  usage.name = "frontier_explorer";
  usage.purpose =
      "Explores: sends move_base to the frontiers of the map, in an order that keeps the whole drive short, until\n"
      "nothing is left that can be reached.";
  usage.reads = {port<nav_msgs::OccupancyGrid>(names::kMap),
                 port<map_msgs::OccupancyGridUpdate>(names::kMapUpdates),
                 port<MapChanges>(names::changesOf(names::kMap)),
                 port<nav_msgs::Odometry>(names::kOdom),
                 port<std_msgs::Bool>(names::kEmergencyStopState),
                 port<std_msgs::Bool>(names::kLocalized),
                 port<std_msgs::String>(names::kMapReplaced),
                 port<ArbiterStatus>(names::kArbiterStatus),
                 port<geometry_msgs::PointStamped>(names::kClickedPoint),
                 port<geometry_msgs::PoseStamped>(names::kInspect),
                 port<sensor_msgs::BatteryState>(names::kBatteryState),
                 port<FleetClaims>(names::kFleetClaims),
                 port<tf2_msgs::TFMessage>(names::kTf),
                 port<tf2_msgs::TFMessage>(names::kTfStatic)};
  usage.publishes = {port<ExplorerStatus>(names::kExplorerStatus),
                     port<visualization_msgs::MarkerArray>(names::kFrontiers),
                     port<geometry_msgs::PoseStamped>(names::kExplorerGoal), port<FleetClaims>(names::kFleetClaims)};
  usage.services = {servicePort<std_srvs::SetBool>(names::kSetExplorationEnabled),
                    servicePort<SetBounds>(names::kSetExplorationBounds),
                    servicePort<std_srvs::Trigger>(names::kClearExplorationBounds),
                    servicePort<std_srvs::Trigger>(names::kClearInspections),
                    servicePort<std_srvs::SetBool>(names::kSetReturnToStart),
                    servicePort<std_srvs::Trigger>(names::kResetExplorer),
                    servicePort<std_srvs::Trigger>(names::kExplainExplorer)};
  usage.calls = {port<move_base_msgs::MoveBaseAction>(names::kMoveBase), servicePort<SaveMap>(names::kSaveMap)};
  addTuningPorts(usage);
  usage.main_parameters = {"autostart",
                           "strategy",
                           "goal_timeout",
                           "return_to_start",
                           "save_map_at_end",
                           "bounds/stay_within",
                           "bounds/keep_out",
                           "until/area",
                           "until/time",
                           "until/distance",
                           "fleet/name",
                           "frontier/min_frontier_cells",
                           "frontier/min_distance"};
  usage.parameters = describeParameters(ExplorerNodeParameters());
  usage.example = "rosrun frontier_pilot frontier_explorer _autostart:=true _until/time:=600";
  return usage;
}

}  // namespace frontier_pilot
