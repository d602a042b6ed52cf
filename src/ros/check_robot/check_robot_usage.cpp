#include "ros/common/help/usages.h"

#include <nav_msgs/Odometry.h>
#include <sensor_msgs/LaserScan.h>
#include <tf2_msgs/TFMessage.h>

#include "ros/check_robot/check_robot_adapter.h"
#include "ros/common/names.h"

namespace frontier_pilot {

NodeUsage checkRobotUsage() {
  NodeUsage usage;
  usage.name = "check_robot";
  usage.purpose =
      "Listens to a robot for some seconds, without moving it, and says in plain words what is there, what is\n"
      "missing and what to set: the rates of scan and odometry, the frames, the scanner's mount, clocks that differ,\n"
      "other nodes that drive, several mappers, simulated time. It publishes nothing.\n"
      "\n"
      "roslaunch frontier_pilot check_robot.launch takes the same arguments as the other launch files: robot, scan,\n"
      "odom, cmd_vel, base_frame, odom_frame, map_frame.";
  usage.reads = {port<sensor_msgs::LaserScan>(names::kScan), port<nav_msgs::Odometry>(names::kOdom),
                 port<tf2_msgs::TFMessage>(names::kTf), port<tf2_msgs::TFMessage>(names::kTfStatic)};
  usage.main_parameters = {"duration"};
  usage.parameters = describeParameters(CheckRobotParameters());
  usage.exit_codes =
      "  0    the robot could drive\n"
      "  1    it could not: each PROBLEM is to be put right first\n"
      "  2    wrong arguments or parameters\n"
      "  3    no ROS master\n";
  usage.example = "rosrun frontier_pilot check_robot scan:=/lidar/scan odom:=/wheels/odom";
  return usage;
}

}  // namespace frontier_pilot
