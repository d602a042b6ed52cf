#pragma once

#include <geometry_msgs/Vector3.h>
#include <nav_msgs/MapMetaData.h>
#include <sensor_msgs/LaserScan.h>

#include <Eigen/Geometry>
#include <string>

#include "frontier_pilot/core/geometry.h"

/// What is wrong with the numbers of a message, by the bounds of core/bounds.h; empty if nothing is wrong. [FLT-1]
namespace frontier_pilot {

/// Why a scan is refused that looksAhead() rejects.
inline constexpr const char* kDoesNotShowAhead = "it does not show what is ahead";

bool isFinite(const geometry_msgs::Vector3& v);
std::string problemOfPlace(double x, double y, double z);
/// For a velocity that the robot reports, not for a commanded one.
std::string problemOf(const Twist2& measured);
/// Checks everything but the values of the ranges.
std::string problemOf(const sensor_msgs::LaserScan& msg);
std::string problemOfMount(const Eigen::Isometry3d& T_base_sensor);
/// For the size of a map and its resolution.
std::string problemOf(const nav_msgs::MapMetaData& info);

}  // namespace frontier_pilot
