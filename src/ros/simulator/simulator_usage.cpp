#include "ros/common/help/usages.h"

#include <frontier_pilot/RemoveObstacle.h>
#include <frontier_pilot/SetPose.h>
#include <frontier_pilot/SpawnObstacle.h>
#include <geometry_msgs/Twist.h>
#include <nav_msgs/OccupancyGrid.h>
#include <nav_msgs/Odometry.h>
#include <rosgraph_msgs/Clock.h>
#include <sensor_msgs/LaserScan.h>
#include <std_msgs/Bool.h>
#include <std_srvs/Empty.h>
#include <std_srvs/SetBool.h>
#include <tf2_msgs/TFMessage.h>

#include "ros/common/names.h"
#include "ros/simulator/simulator_adapter.h"

namespace frontier_pilot {

NodeUsage simulatorUsage() {
  NodeUsage usage;
  usage.name = "simulator";
  usage.purpose =
      "Simulates robots with wheels, odometry and a laser scanner in the world of a map_server YAML, and\n"
      "publishes the time.";
  usage.reads = {port<geometry_msgs::Twist>(names::kCmdVel)};
  usage.publishes = {port<sensor_msgs::LaserScan>(names::kScan),  port<nav_msgs::Odometry>(names::kOdom),
                     port<rosgraph_msgs::Clock>(names::kClock),   port<tf2_msgs::TFMessage>(names::kTf),
                     port<tf2_msgs::TFMessage>(names::kTfStatic), port<nav_msgs::Odometry>(names::kGroundTruth),
                     port<std_msgs::Bool>(names::kStalled),       port<nav_msgs::OccupancyGrid>(names::kWorld)};
  usage.services = {servicePort<std_srvs::Empty>(names::kResetPositions), servicePort<SetPose>(names::kSetPose),
                    servicePort<SpawnObstacle>(names::kSpawnObstacle),
                    servicePort<RemoveObstacle>(names::kRemoveObstacle),
                    servicePort<std_srvs::SetBool>(names::kPauseSimulator)};
  usage.parameters = describeParameters(SimulatorNodeParameters());
  // The first one is the world, the only one that has to be given.
  usage.main_parameters = {usage.parameters.front().name, "x", "y", "yaw", "speed", "seed", "odom_noise"};
  usage.example = "rosrun frontier_pilot simulator _world:=$(rospack find frontier_pilot)/config/worlds/flat.yaml";
  return usage;
}

}  // namespace frontier_pilot
