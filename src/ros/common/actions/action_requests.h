#pragma once

#include <actionlib_msgs/GoalID.h>
#include <ros/time.h>

#include "frontier_pilot/core/time.h"

/// How an action server treats the ids and stamps of goals and cancels. A stamp of zero stays zero: to actionlib a goal
/// without a stamp was sent now, and a cancel without one is for the goal with its id, or for all if the id is empty.
namespace frontier_pilot {

/// Why a request is unusable; null if it is usable.
const char* problemOf(const actionlib_msgs::GoalID& id);

/// `stamp`, or `now` if it lies in the future or is not a valid ROS time: no request can come from the future.
ros::Time stampOrNow(const ros::Time& stamp, Time now);
/// The same for a goal, but zero instead of `now`: otherwise an earlier cancel of all goals up to now would recall it.
ros::Time goalStamp(const ros::Time& stamp, Time now);

}  // namespace frontier_pilot
