#include "ros/common/ros_timer.h"

#include <algorithm>
#include <utility>

#include "ros/common/clock.h"

namespace frontier_pilot {

namespace {

constexpr double kSimulatedPoll = 0.005;  ///< because a simulated clock may run much faster than a real one [s]
constexpr double kFastestPoll = 0.002;    ///< [s]
constexpr double kSlowestPoll = 0.01;     ///< [s]

/// The period at which the ROS clock is polled: a tenth of the timer's period if the clock is a real one.
ros::WallDuration pollPeriod(Duration period) {
  if (ros::Time::isSimTime()) return ros::WallDuration(kSimulatedPoll);
  return ros::WallDuration(std::clamp(0.1 * toSeconds(period), kFastestPoll, kSlowestPoll));
}

}  // namespace

RosTimer::RosTimer(const ros::NodeHandle& node, Duration period, std::function<void()> tick)
    : schedule_(period), tick_(std::move(tick)) {
  poll_ = ros::NodeHandle(node).createSteadyTimer(pollPeriod(period), [this](const ros::SteadyTimerEvent&) { poll(); });
}

void RosTimer::poll() {
  // The clock is read only once: if a tick takes longer than its period, the node has to process its messages before
  // the next tick.
  const Time now = rosNow();
  while (schedule_.isDue(now)) tick_();
}

}  // namespace frontier_pilot
