#pragma once

#include <ros/node_handle.h>
#include <ros/steady_timer.h>

#include <functional>

#include "frontier_pilot/core/tick_schedule.h"

namespace frontier_pilot {

/// Ticks once per period of ROS time, as ros::Timer does, on the node's own queue. Unlike ros::Timer it polls the clock
/// from a steady timer: it goes on after any jump of the clock, and a time near the end of ROS time causes no
/// exception, as it would in the arithmetic of roscpp's timer thread. If several ticks fall between two polls of a fast
/// simulation, there are two. [FLT-1]
class RosTimer {
 public:
  RosTimer(const ros::NodeHandle& node, Duration period, std::function<void()> tick);
  RosTimer(const RosTimer&) = delete;
  RosTimer& operator=(const RosTimer&) = delete;

 private:
  void poll();

  TickSchedule schedule_;
  std::function<void()> tick_;
  ros::SteadyTimer poll_;
};

}  // namespace frontier_pilot
