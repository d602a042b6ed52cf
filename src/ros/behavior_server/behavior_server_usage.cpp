#include "ros/common/help/usages.h"

#include <frontier_pilot/ArbiterStatus.h>
#include <frontier_pilot/BackUpAction.h>
#include <frontier_pilot/DriveOnHeadingAction.h>
#include <frontier_pilot/SpinAction.h>
#include <frontier_pilot/WaitAction.h>
#include <geometry_msgs/PolygonStamped.h>
#include <geometry_msgs/Twist.h>
#include <sensor_msgs/LaserScan.h>
#include <std_msgs/Bool.h>
#include <tf2_msgs/TFMessage.h>

#include "ros/behavior_server/behavior_server_adapter.h"
#include "ros/common/names.h"

namespace frontier_pilot {

NodeUsage behaviorServerUsage() {
  NodeUsage usage;
  usage.name = "behavior_server";
  usage.purpose =
      "Spins, backs up, drives straight ahead and waits, each as an action; stops before it touches what the scan\n"
      "shows.";
  usage.reads = {port<sensor_msgs::LaserScan>(names::kScan), port<std_msgs::Bool>(names::kEmergencyStopState),
                 port<ArbiterStatus>(names::kArbiterStatus), port<tf2_msgs::TFMessage>(names::kTf),
                 port<tf2_msgs::TFMessage>(names::kTfStatic)};
  usage.publishes = {port<geometry_msgs::Twist>(names::kCmdVelBehavior),
                     port<geometry_msgs::PolygonStamped>(names::kFootprint)};
  usage.actions = {port<SpinAction>(names::kSpin), port<BackUpAction>(names::kBackUp),
                   port<DriveOnHeadingAction>(names::kDriveOnHeading), port<WaitAction>(names::kWait)};
  addTuningPorts(usage);
  usage.main_parameters = {"max_rotational_vel", "default_linear_vel", "simulate_ahead_time", "footprint/padding"};
  usage.parameters = describeParameters(BehaviorServerParameters());
  usage.example = "rosrun frontier_pilot behavior_server _max_rotational_vel:=0.8";
  return usage;
}

}  // namespace frontier_pilot
