#pragma once

#include <geometry_msgs/Vector3.h>
#include <nav_msgs/MapMetaData.h>
#include <sensor_msgs/LaserScan.h>

#include <Eigen/Geometry>
#include <string>

#include "frontier_pilot/core/geometry.h"

/// What is wrong with the numbers of a message, each judged by itself and by the bounds of core/bounds.h; empty if
/// nothing is. [FLT-1]
namespace frontier_pilot {

bool isFinite(const geometry_msgs::Vector3& v);
std::string problemOfPlace(double x, double y, double z);
/// Of a velocity that the robot reports, not of one that is asked for.
std::string problemOf(const Twist2& measured);
/// All but whether the ranges themselves are usable.
std::string problemOf(const sensor_msgs::LaserScan& msg);
std::string problemOfMount(const Eigen::Isometry3d& T_base_sensor);
/// Of a map's size and its cells'.
std::string problemOf(const nav_msgs::MapMetaData& info);

}  // namespace frontier_pilot
