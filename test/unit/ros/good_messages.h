#pragma once

#include <nav_msgs/OccupancyGrid.h>
#include <sensor_msgs/LaserScan.h>

/// Messages in which nothing is wrong, for a test to change one thing in.
namespace frontier_pilot {

inline sensor_msgs::LaserScan goodScan() {
  sensor_msgs::LaserScan msg;
  msg.angle_min = -1.0F;
  msg.angle_max = 1.0F;
  msg.angle_increment = 0.5F;
  msg.range_min = 0.12F;
  msg.range_max = 3.5F;
  msg.ranges = {1.0F, 1.1F, 1.2F, 1.3F, 1.4F};
  return msg;
}

inline nav_msgs::OccupancyGrid goodMap() {
  nav_msgs::OccupancyGrid msg;
  msg.info.width = 3;
  msg.info.height = 2;
  msg.info.resolution = 0.05F;
  msg.info.origin.orientation.w = 1.0;
  msg.data = {-1, 0, 100, 50, 0, -1};
  return msg;
}

}  // namespace frontier_pilot
