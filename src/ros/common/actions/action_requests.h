#pragma once

#include <actionlib_msgs/GoalID.h>
#include <ros/time.h>

#include "frontier_pilot/core/time.h"

/// What an action server makes of the names and stamps of goals and cancels. An unset stamp stays unset: to actionlib
/// it means that a goal is of now, and that a cancel is of one goal only, or of all.
namespace frontier_pilot {

/// What makes a request unusable; null if nothing does.
const char* problemOf(const actionlib_msgs::GoalID& id);

/// `stamp`, or `now` if it lies beyond that or is none of ROS' times: nothing was asked for in the future.
ros::Time stampOrNow(const ros::Time& stamp, Time now);
/// The same for a goal, unset instead of now: a cancel of what came until now came before it.
ros::Time goalStamp(const ros::Time& stamp, Time now);

}  // namespace frontier_pilot
