#pragma once

#include <ros/node_handle.h>
#include <ros/steady_timer.h>
#include <ros/subscriber.h>

#include <functional>

#include "frontier_pilot/core/tick_schedule.h"
#include "ros/common/messages/checked_subscription.h"

namespace frontier_pilot {

/// Ticks once per period of ROS time, as ros::Timer does, on the node's own queue. Unlike ros::Timer it goes on after
/// any jump of the clock, and a time near the end of ROS time causes no exception, as it would in the arithmetic of
/// roscpp's timer thread. It looks at a simulated clock when that is published, and at a real one when a tick should be
/// due, where ros::Timer looks at a simulated clock a thousand times a second. If several ticks fall between two looks
/// at a fast simulation, there are two. [FLT-1]
class RosTimer {
 public:
  RosTimer(const ros::NodeHandle& node, Duration period, std::function<void()> tick);
  RosTimer(const RosTimer&) = delete;
  RosTimer& operator=(const RosTimer&) = delete;

 private:
  void look();

  TickSchedule schedule_;
  std::function<void()> tick_;
  ros::SteadyTimer poll_;
  UnreadableMessages unreadable_;
  ros::Subscriber clock_;  ///< if the clock is a simulated one
};

}  // namespace frontier_pilot
