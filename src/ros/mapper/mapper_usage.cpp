#include "ros/common/help/usages.h"

#include <frontier_pilot/LoadMap.h>
#include <frontier_pilot/MapChanges.h>
#include <frontier_pilot/SaveMap.h>
#include <geometry_msgs/PoseWithCovarianceStamped.h>
#include <map_msgs/OccupancyGridUpdate.h>
#include <nav_msgs/GetMap.h>
#include <nav_msgs/MapMetaData.h>
#include <nav_msgs/OccupancyGrid.h>
#include <nav_msgs/Odometry.h>
#include <sensor_msgs/LaserScan.h>
#include <std_msgs/Bool.h>
#include <std_msgs/String.h>
#include <std_srvs/Trigger.h>
#include <tf2_msgs/TFMessage.h>

#include "ros/common/names.h"
#include "ros/mapper/mapper_adapter.h"

namespace frontier_pilot {

NodeUsage mapperUsage() {
  NodeUsage usage;
  usage.name = "mapper";
  usage.purpose =
      "Maps with laser scans and odometry, closes loops, and publishes where the robot is; or localises in a map\n"
      "that is loaded.";
  usage.reads = {port<sensor_msgs::LaserScan>(names::kScan), port<nav_msgs::Odometry>(names::kOdom),
                 port<geometry_msgs::PoseWithCovarianceStamped>(names::kInitialPose),
                 port<tf2_msgs::TFMessage>(names::kTf), port<tf2_msgs::TFMessage>(names::kTfStatic)};
  usage.publishes = {port<nav_msgs::OccupancyGrid>(names::kMap),
                     port<map_msgs::OccupancyGridUpdate>(names::kMapUpdates),
                     port<MapChanges>(names::changesOf(names::kMap)),
                     port<nav_msgs::MapMetaData>(names::kMapMetadata),
                     port<std_msgs::Bool>(names::kLocalized),
                     port<std_msgs::String>(names::kMapReplaced),
                     port<tf2_msgs::TFMessage>(names::kTf)};
  usage.services = {servicePort<nav_msgs::GetMap>(names::kDynamicMap), servicePort<SaveMap>(names::kSaveMap),
                    servicePort<LoadMap>(names::kLoadMap), servicePort<std_srvs::Trigger>(names::kLocalize),
                    servicePort<std_srvs::Trigger>(names::kResetMap)};
  usage.main_parameters = {"map_file",
                           "localize_only",
                           "mapper/trust_odometry",
                           "mapper/map/resolution",
                           "mapper/insertion/max_clear_range",
                           "mapper/slam/local/tracker/odometry/distance"};
  usage.parameters = describeParameters(MapperNodeParameters());
  usage.example = "rosrun frontier_pilot mapper _map_file:=/path/floor _localize_only:=true";
  return usage;
}

}  // namespace frontier_pilot
