#include "ros/common/help/usages.h"

#include <frontier_pilot/ArbiterStatus.h>
#include <frontier_pilot/AvoiderStatus.h>
#include <geometry_msgs/Twist.h>
#include <nav_msgs/Odometry.h>
#include <sensor_msgs/LaserScan.h>
#include <std_msgs/Bool.h>
#include <std_srvs/SetBool.h>
#include <tf2_msgs/TFMessage.h>

#include "ros/common/names.h"
#include "ros/obstacle_avoider/obstacle_avoider_adapter.h"

namespace frontier_pilot {

NodeUsage obstacleAvoiderUsage() {
  NodeUsage usage;
  usage.name = "obstacle_avoider";
  usage.purpose =
      "Turns the robot away from obstacles ahead, whoever drives, for driving by hand. What it commands has the\n"
      "highest priority of the arbiter.";
  usage.reads = {port<sensor_msgs::LaserScan>(names::kScan), port<nav_msgs::Odometry>(names::kOdom),
                 port<tf2_msgs::TFMessage>(names::kTf),      port<tf2_msgs::TFMessage>(names::kTfStatic),
                 port<geometry_msgs::Twist>(names::kCmdVel), port<std_msgs::Bool>(names::kEmergencyStopState),
                 port<ArbiterStatus>(names::kArbiterStatus)};
  usage.publishes = {port<geometry_msgs::Twist>(names::kCmdVelAvoid), port<AvoiderStatus>(names::kAvoiderStatus)};
  usage.services = {servicePort<std_srvs::SetBool>(names::kSetObstacleAvoidEnabled)};
  addTuningPorts(usage);
  usage.main_parameters = {"stop_distance", "clear_distance", "reverse_speed", "enabled"};
  usage.parameters = describeParameters(ObstacleAvoiderNodeParameters());
  usage.example = "rosrun frontier_pilot obstacle_avoider _stop_distance:=0.3";
  return usage;
}

}  // namespace frontier_pilot
