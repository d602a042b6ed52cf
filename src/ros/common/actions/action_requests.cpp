#include "ros/common/actions/action_requests.h"

#include <cstddef>

#include "frontier_pilot/core/bounds.h"
#include "ros/common/clock.h"

namespace frontier_pilot {

namespace {

bool hasCome(const ros::Time& stamp, Time now) { return stamp.nsec < 1'000'000'000U && toTime(stamp) <= now; }

}  // namespace

const char* problemOf(const actionlib_msgs::GoalID& id) {
  return id.id.size() > bounds::kMostGoalId ? "goal id longer than 1024 characters" : nullptr;
}

ros::Time stampOrNow(const ros::Time& stamp, Time now) { return hasCome(stamp, now) ? stamp : toRosTime(now); }

ros::Time goalStamp(const ros::Time& stamp, Time now) { return hasCome(stamp, now) ? stamp : ros::Time(); }

}  // namespace frontier_pilot
