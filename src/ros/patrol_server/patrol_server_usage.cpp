#include "ros/common/help/usages.h"

#include <frontier_pilot/ArbiterStatus.h>
#include <frontier_pilot/PatrolAction.h>
#include <geometry_msgs/Twist.h>
#include <nav_msgs/Odometry.h>
#include <sensor_msgs/LaserScan.h>
#include <std_msgs/Bool.h>
#include <tf2_msgs/TFMessage.h>

#include "ros/common/names.h"
#include "ros/patrol_server/patrol_server_adapter.h"

namespace frontier_pilot {

NodeUsage patrolServerUsage() {
  NodeUsage usage;
  usage.name = "patrol_server";
  usage.purpose =
      "Drives squares, triangles and circles by odometry, as an action: goal.x is the shape (1 square, 2 triangle,\n"
      "3 circle), goal.y its side or radius [m], goal.z the number of laps.\n"
      "Stops before it touches what the scan shows.";
  usage.reads = {port<sensor_msgs::LaserScan>(names::kScan),
                 port<nav_msgs::Odometry>(names::kOdom),
                 port<std_msgs::Bool>(names::kEmergencyStopState),
                 port<ArbiterStatus>(names::kArbiterStatus),
                 port<tf2_msgs::TFMessage>(names::kTf),
                 port<tf2_msgs::TFMessage>(names::kTfStatic)};
  usage.publishes = {port<geometry_msgs::Twist>(names::kCmdVelPatrol)};
  usage.actions = {port<PatrolAction>(names::kPatrol)};
  addTuningPorts(usage);
  usage.main_parameters = {"linear_speed", "turn_speed", "max_side", "max_laps", "check_collisions"};
  usage.parameters = describeParameters(PatrolServerParameters());
  usage.example = "rosrun frontier_pilot patrol_server _linear_speed:=0.1";
  return usage;
}

}  // namespace frontier_pilot
